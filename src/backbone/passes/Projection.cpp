#include "backbone/passes/Projection.h"

#include <cmath>
#include <utility>

#include "backbone/frame/ShaderLibrary.h"
#include "backbone/passes/Composite.h"
#include "gl/Label.h"
#include "shared/falloff.h"

namespace aolib {

namespace {

constexpr int kDepthUnit = 0;
constexpr int kVisibilityUnit = 1;
constexpr int kCubeDepthUnit = 2;
constexpr int kPagesUnit = 3;
constexpr int kBestUnit = 4;
constexpr int kRefinedUnit = 5;
constexpr int kHalfUnit = 6;
/// Defined in the shaders that look at pages and at refined pixels, too.
constexpr const char* kWithPages = "AO_PAGES";
constexpr const char* kWithRefined = "AO_REFINED";

/// Two faces' layers as one number, as shaders/cubemap/projection.glsl takes them apart.
int pairOfLayers(const CubeMapProjector& projector, int face) {
    const auto bits = [&](int f) {
        return static_cast<std::uint32_t>(projector.layer(f)) & 0xFFFFU; // none is 0xFFFF
    };
    return static_cast<int>(bits(face) | bits(face + 1) << 16U);
}

/// Length up to which a texel on a surface may project onto it, world units.
float reachOfTexels(const Options& options) {
    return options.falloff == Falloff::Off ? shared::kEndless : options.radius;
}

const std::vector<CubeMapProjector*> kNoProjectors;

} // namespace

Result<Projection> Projection::create(const BackboneContext& context) {
    Projection projection;
    for (std::size_t variant = 0; variant < projection.shade_.size(); ++variant) {
        const char* pages = variant % 2 == 1 ? kWithPages : "";
        const char* refined = variant / 2 == 1 ? kWithRefined : "";
        auto project =
            buildShader(context.gl, "fullscreen.vert", "cubemap/project.frag", {pages, refined});
        if (!project) {
            return project.status();
        }
        auto shade =
            buildShader(context.gl, "fullscreen.vert", "cubemap/shade.frag", {pages, refined});
        if (!shade) {
            return shade.status();
        }
        projection.project_[variant] = std::move(*project);
        projection.shade_[variant] = std::move(*shade);
    }
    for (std::size_t variant = 0; variant < projection.upsample_.size(); ++variant) {
        const char* refined = variant == 1 ? kWithRefined : "";
        auto shade =
            buildShader(context.gl, "fullscreen.vert", "cubemap/shade_half.frag", {refined});
        if (!shade) {
            return shade.status();
        }
        auto upsample =
            buildShader(context.gl, "fullscreen.vert", "cubemap/upsample.frag", {refined});
        if (!upsample) {
            return upsample.status();
        }
        projection.shadeHalf_[variant] = std::move(*shade);
        projection.upsample_[variant] = std::move(*upsample);
    }
    return projection;
}

gl::GLSLShader& Projection::variant(Variants& shaders, const ProjectedCubeMaps& cubeMaps) {
    return shaders[(cubeMaps.atlas.pages.empty() ? 0U : 1U) +
                   (cubeMaps.refined == nullptr ? 0U : 2U)];
}

void Projection::bind(gl::GLSLShader& shader, const FrameContext& context,
                      const ProjectedCubeMaps& cubeMaps) {
    shader.bind();
    context.host.bindDepth(kDepthUnit);
    shader.set("uDepth", kDepthUnit);
    context.frame.camera.setUniforms(shader, context.frame.size, context.frame.clip);
    shader.set("uCubes", static_cast<int>(cubeMaps.list.size()));
    // Samplers of different types must not share a unit even where they are not read.
    shader.set("uCubeVisibility", kVisibilityUnit);
    shader.set("uCubeDepth", kCubeDepthUnit);
    shader.set("uPages", kPagesUnit);
    shader.set("uRefined", kRefinedUnit);
    if (cubeMaps.refined != nullptr) {
        cubeMaps.refined->bind(kRefinedUnit);
    }
    if (cubeMaps.atlas.faces.empty() || cubeMaps.list.empty()) {
        return;
    }
    cubeMaps.atlas.faces.bind(shader, kVisibilityUnit, kCubeDepthUnit);
    cubeMaps.atlas.faces.bindPages(shader, kPagesUnit);
    shader.set("uReach", reachOfTexels(context.options));
    shader.set("uPageScale", cubeMaps.atlas.pages.scale());
    std::vector<glm::vec4> toEye;
    std::vector<glm::vec4> codes;
    std::vector<glm::ivec4> layers;
    for (const CubeMapProjector* projector : cubeMaps.list) {
        toEye.emplace_back(
            glm::vec3(context.frame.camera.eye() - glm::dvec3(projector->position())),
            std::exp2(projector->fade()));
        codes.emplace_back(projector->depthCode(), 0.0F, 0.0F);
        layers.emplace_back(pairOfLayers(*projector, 0), pairOfLayers(*projector, 2),
                            pairOfLayers(*projector, 4), 0);
    }
    shader.set("uCubeToEye", toEye);
    shader.set("uDepthCode", codes);
    shader.set("uFaceLayers", layers);
}

void Projection::bindHalf(gl::GLSLShader& shader, const FrameContext& context,
                          const ProjectedCubeMaps& cubeMaps, const gl::RenderToTexture2D& half) {
    bind(shader, context, {cubeMaps.atlas, kNoProjectors, cubeMaps.refined});
    half.bindTexture(0, kHalfUnit);
    shader.set("uHalf", kHalfUnit);
}

Result<gl::GLSLShader*> Projection::bindShade(const FrameContext& context,
                                              const ProjectedCubeMaps& cubeMaps,
                                              ProjectedPictures& pictures) {
    gl::GLSLShader* shader = &variant(shade_, cubeMaps);
    if (context.options.cubeMaps.halfResolution) {
        const auto half = project(context, cubeMaps, pictures);
        if (!half) {
            return half.status();
        }
        shader = &shadeHalf_[cubeMaps.refined == nullptr ? 0 : 1];
        bindHalf(*shader, context, cubeMaps, **half);
    } else {
        bind(*shader, context, cubeMaps);
    }
    return shader;
}

AoStatus Projection::shade(const FrameContext& context, const ProjectedCubeMaps& cubeMaps,
                           ProjectedPictures& pictures) {
    const gl::DebugGroup group(context.gl, "aolib: project and blend");
    const auto shader = bindShade(context, cubeMaps, pictures);
    if (!shader) {
        return shader.status();
    }
    (*shader)->set("uOrigin", context.frame.origin);
    (*shader)->set("uContrast", context.options.contrast);
    (*shader)->set("uKnownAlone", 0);
    beginHostColours(context);
    blendIntoHost(context);
    endHostColours(context);
    return {};
}

Result<const gl::RenderToTexture2D*> Projection::projectToTexture(const FrameContext& context,
                                                                  const ProjectedCubeMaps& cubeMaps,
                                                                  ProjectedPictures& pictures,
                                                                  bool withDepth) {
    const gl::DebugGroup group(context.gl, "aolib: project");
    if (AoStatus status =
            pictures.visibility.reset(context.gl, {.width = context.frame.size.x,
                                                   .height = context.frame.size.y,
                                                   .targets = {gl::RenderToTexture2D::Format::R32F},
                                                   .depth = gl::RenderToTexture2D::Depth::Depth16,
                                                   .label = "aolib/frame/visibility"});
        !status) {
        return status;
    }
    const auto shader = bindShade(context, cubeMaps, pictures);
    if (!shader) {
        return shader.status();
    }
    const gl::Functions& gl = context.gl;
    constexpr float kUnknown[]{-1.0F, 0.0F, 0.0F, 0.0F};
    constexpr float kFar = 1.0F;
    (*shader)->set("uOrigin", glm::ivec2(0));
    (*shader)->set("uContrast", 1.0F);
    (*shader)->set("uKnownAlone", 1);
    pictures.visibility.bindAsTarget(0);
    gl.ClearBufferfv(GL_COLOR, 0, kUnknown);
    if (withDepth) {
        gl.ClearBufferfv(GL_DEPTH, 0, &kFar);
        gl.Enable(GL_DEPTH_TEST);
        gl.DepthFunc(GL_ALWAYS);
    }
    context.emptyVertexArray.drawFullscreen();
    gl.DepthFunc(GL_LESS);
    gl.Disable(GL_DEPTH_TEST);
    return &pictures.visibility;
}

AoStatus Projection::prepare(const BackboneContext& context, const glm::ivec2& size,
                             gl::RenderToTexture2D& target) {
    return target.reset(context.gl, {.width = size.x,
                                     .height = size.y,
                                     .targets = {gl::RenderToTexture2D::Format::RGBA32F},
                                     .label = "aolib/frame/best"});
}

Result<const gl::RenderToTexture2D*> Projection::project(const FrameContext& context,
                                                         const ProjectedCubeMaps& cubeMaps,
                                                         ProjectedPictures& pictures) {
    const int cubes = static_cast<int>(cubeMaps.list.size());
    const int stride = context.options.cubeMaps.halfResolution ? 2 : 1;
    const bool single = context.options.cubeMaps.projection == ProjectionMethod::SinglePass;
    const int perPass = single ? std::max(cubes, 1) : 1;
    for (gl::RenderToTexture2D& target : pictures.best) {
        if (AoStatus status = prepare(context, (context.frame.size + stride - 1) / stride, target);
            !status) {
            return status;
        }
        if (perPass >= cubes) {
            break;
        }
    }
    gl::GLSLShader& shader = variant(project_, cubeMaps);
    bind(shader, context, cubeMaps);
    shader.set("uBest", kBestUnit);
    shader.set("uStride", stride);
    const gl::RenderToTexture2D* best = nullptr;
    for (int first = 0; first == 0 || first < cubes; first += perPass) {
        const gl::RenderToTexture2D* next =
            best == &pictures.best[0] ? &pictures.best[1] : &pictures.best[0];
        next->bindAsTarget(0);
        if (best != nullptr) {
            best->bindTexture(0, kBestUnit);
        }
        shader.set("uFirstPass", best == nullptr ? 1 : 0);
        shader.set("uFirstCube", first);
        shader.set("uEndCube", std::min(first + perPass, cubes));
        context.emptyVertexArray.drawFullscreen();
        best = next;
    }
    return best;
}

Result<const gl::RenderToTexture2D*> Projection::apply(const FrameContext& context,
                                                       const ProjectedCubeMaps& cubeMaps,
                                                       ProjectedPictures& pictures) {
    const gl::DebugGroup group(context.gl, "aolib: project cube maps");
    const auto projected = project(context, cubeMaps, pictures);
    if (!projected || !context.options.cubeMaps.halfResolution) {
        return projected;
    }
    if (AoStatus status = prepare(context, context.frame.size, pictures.upsampled); !status) {
        return status;
    }
    gl::GLSLShader& shader = upsample_[cubeMaps.refined == nullptr ? 0 : 1];
    bindHalf(shader, context, cubeMaps, **projected);
    pictures.upsampled.bindAsTarget(0);
    context.emptyVertexArray.drawFullscreen();
    return &pictures.upsampled;
}

std::size_t ProjectedPictures::bytes() const {
    std::size_t sum = (upsampled ? upsampled.bytes() : 0) + (visibility ? visibility.bytes() : 0);
    for (const gl::RenderToTexture2D& target : best) {
        sum += target ? target.bytes() : 0;
    }
    return sum;
}

} // namespace aolib
