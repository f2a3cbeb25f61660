#include "bake/scatter/ScatterPasses.h"

#include <algorithm>
#include <array>
#include <utility>

#include <glm/gtc/type_ptr.hpp>

#include "bake/gpu/BakeShaders.h"
#include "bake/scatter/FirstError.h"
#include "gl/Label.h"

namespace aolib::bake {

namespace {

using Format = gl::RenderToTexture2D::Format;
using Depth = gl::RenderToTexture2D::Depth;

/// Points per draw call. A software rasteriser keeps the vertices of a call in memory that it asks
/// the system for each time, where they are many: a seventh of its time, with all in one call.
constexpr int pointsAtOnce = 1024;

/// A reach without end, for shaders.
constexpr double noEnd = 1e30;

// Of compatibility contexts, which the core header does not declare.
constexpr GLenum pointSmooth = 0x0B10;

/// Points of the size that the shader says, and square; as the host had it when it goes.
class ShaderPoints {
public:
    explicit ShaderPoints(const gl::Functions& gl)
        : gl_(gl), sized_(gl.IsEnabled(GL_PROGRAM_POINT_SIZE)),
          smooth_(gl.capabilities.compatibility ? gl.IsEnabled(pointSmooth) : GLboolean{GL_FALSE}) {
        gl_.Enable(GL_PROGRAM_POINT_SIZE);
        if (smooth_ == GL_TRUE) {
            gl_.Disable(pointSmooth);
        }
    }
    ~ShaderPoints() {
        if (sized_ == GL_FALSE) {
            gl_.Disable(GL_PROGRAM_POINT_SIZE);
        }
        if (smooth_ == GL_TRUE) {
            gl_.Enable(pointSmooth);
        }
    }
    ShaderPoints(const ShaderPoints&) = delete;
    ShaderPoints& operator=(const ShaderPoints&) = delete;

private:
    const gl::Functions& gl_;
    GLboolean sized_;
    GLboolean smooth_;
};

} // namespace

Result<ScatterPasses> ScatterPasses::create(const gl::Functions& gl, const Settings& settings,
                                            const BakeVertices& vertices,
                                            std::span<const float> facets) {
    ScatterPasses passes;
    passes.gl_ = &gl;
    passes.settings_ = settings;
    passes.vertices_ = &vertices;
    FirstError firstError;
    const auto target = [&](const glm::ivec2& size, std::vector<Format> formats, Depth depth,
                            const char* label) {
        gl::RenderToTexture2D::Settings wanted;
        wanted.width = size.x;
        wanted.height = size.y;
        wanted.targets = std::move(formats);
        wanted.depth = depth;
        wanted.label = label;
        return gl::RenderToTexture2D::create(gl, wanted);
    };
    const glm::ivec2 raster(settings.rasterSize);
    if (settings.slabs) {
        firstError.assign(passes.slabs_, ScatterSlabs::create(gl, settings.rasterSize, vertices));
    }
    if (!settings.draws) {
        firstError.assign(
            passes.surfaceShader_,
            settings.places
                ? buildBakeShader(gl, "bake/scatter_position.vert", "bake/scatter_position.frag")
                : buildBakeShader(gl, "bake/scatter_triangle.vert", "bake/scatter_triangle.frag"));
        firstError.assign(passes.surface_,
                          target(raster, {Format::RGBA32F}, Depth::Depth32F, "aolib/bake/surface"));
        return firstError.status() ? Result<ScatterPasses>(std::move(passes)) : firstError.status();
    }
    firstError.assign(passes.surfaceShader_, buildBakeShader(gl, "bake/scatter_surface.vert",
                                                             "bake/scatter_surface.frag"));
    firstError.assign(passes.pointShader_,
                      buildBakeShader(gl, "bake/scatter_point.vert", "bake/scatter_point.frag"));
    const MapStack& stack = settings.stack;
    const glm::ivec2 size(stack.mapSize.x, stack.mapSize.y * stack.count);
    firstError.assign(passes.surface_, target(raster, {Format::RGBA32F, Format::RG16F},
                                              Depth::Depth32F, "aolib/bake/surface"));
    firstError.assign(passes.sums_,
                      target(size, {Format::RGBA32F}, Depth::None, "aolib/bake/sums"));
    firstError.assign(passes.facets_, gl::TextureStack::create(gl, {size.x, size.y, 1, Format::R32F,
                                                                    "aolib/bake/facets"}));
    firstError.assign(passes.points_, gl::VertexArray::createEmpty(gl, "aolib/bake/points"));
    if (!firstError.status()) {
        return firstError.status();
    }
    passes.facets_.upload(0, {0, 0}, size, facets.data());
    passes.sums_.bindAsTarget(0);
    const glm::vec4 nothing(0.0F);
    gl.ClearBufferfv(GL_COLOR, 0, glm::value_ptr(nothing));
    return passes;
}

void ScatterPasses::clearSurface() const {
    surface_.bindAllAsTargets();
    const glm::vec4 nothing(0.0F);
    gl_->ClearBufferfv(GL_COLOR, 0, glm::value_ptr(nothing));
    if (settings_.draws) {
        gl_->ClearBufferfv(GL_COLOR, 1, glm::value_ptr(nothing));
    }
    const float farthest = 1.0F;
    gl_->ClearBufferfv(GL_DEPTH, 0, &farthest);
}

/// Makes ready for drawing triangles.
void ScatterPasses::beginSurface(const LightView& view, const glm::mat4& toClip) {
    clearSurface();
    gl_->Enable(GL_DEPTH_TEST);
    surfaceShader_.bind();
    surfaceShader_.set("uToLight", toClip);
    if (!settings_.draws) {
        return;
    }
    surfaceShader_.set("uMapSize", glm::vec2(settings_.stack.mapSize));
    surfaceShader_.set("uFirstMap", settings_.stack.first);
    surfaceShader_.set("uMapCount", settings_.stack.count);
    surfaceShader_.set("uPixelSize", pictureSide / float(settings_.rasterSize));
    surfaceShader_.set("uDirection", glm::vec3(view.direction));
    surfaceShader_.set("uGround", settings_.ground);
    surfaceShader_.set("uReach", static_cast<float>(std::min(view.reach, noEnd)));
    surfaceShader_.set("uDensity", settings_.density);
}

AoStatus ScatterPasses::drawSurface(const LightView& view, const std::function<void()>& take) {
    if (slabs_) {
        return drawSlabs(view, take);
    }
    {
        const gl::DebugGroup group(*gl_, "aolib/bake/direction");
        beginSurface(view, view.toClip);
        if (settings_.draws) {
            vertices_->draw();
        } else {
            vertices_->drawNumbered(surfaceShader_);
        }
        gl_->Disable(GL_DEPTH_TEST);
    }
    take();
    return {};
}

AoStatus ScatterPasses::drawSlabs(const LightView& view, const std::function<void()>& take) {
    const gl::DebugGroup group(*gl_, "aolib/bake/slabs");
    slabs_->begin(view);
    for (slab_ = 0; slab_ < slabs_->count(); ++slab_) {
        if (AoStatus status = slabs_->prepare(slab_); !status) {
            return status;
        }
        if (slabs_->empty(slab_)) {
            continue;
        }
        slabs_->drawBefore(slab_);
        beginSurface(view, slabs_->toClip(slab_));
        slabs_->draw(surfaceShader_, slab_);
        gl_->Disable(GL_DEPTH_TEST);
        take();
    }
    return {};
}

void ScatterPasses::scatter(const LightView& view) {
    const gl::DebugGroup group(*gl_, "aolib/bake/points");
    const ShaderPoints points(*gl_);
    sums_.bindAsTarget(0);
    surface_.bindTexture(0, 0);
    surface_.bindTexture(1, 1);
    pointShader_.bind();
    pointShader_.set("uSize", 1);
    pointShader_.set("uSurface", 0);
    pointShader_.set("uTargetSize", glm::vec2(sums_.width(), sums_.height()));
    facets_.bind(2);
    pointShader_.set("uFacets", 2);
    pointShader_.set("uPointSize", settings_.pointSize);
    pointShader_.set("uDirection", glm::vec3(view.direction));
    gl_->Enablei(GL_BLEND, 0);
    gl_->BlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
    pointShader_.set("uWidth", settings_.rasterSize);
    const int count = settings_.rasterSize * settings_.rasterSize;
    for (int first = 0; first < count; first += pointsAtOnce) {
        points_.drawGenerated(GL_POINTS, std::min(pointsAtOnce, count - first), first);
    }
    gl_->Disablei(GL_BLEND, 0);
}

const std::vector<glm::vec4>& ScatterPasses::readSurface() {
    picture_.resize(static_cast<std::size_t>(settings_.rasterSize) *
                    static_cast<std::size_t>(settings_.rasterSize));
    surface_.bindForReading(0);
    gl_->ReadPixels(0, 0, settings_.rasterSize, settings_.rasterSize, GL_RGBA, GL_FLOAT,
                    picture_.data());
    if (slabs_) {
        const std::span<const std::uint32_t> numbers = slabs_->numbers(slab_);
        const int channel = settings_.places ? 3 : 2;
        for (glm::vec4& pixel : picture_) {
            if (pixel[channel] > 0.0F) {
                const auto place = static_cast<std::size_t>(pixel[channel]) - 1;
                pixel[channel] = static_cast<float>(numbers[place] + 1);
            }
        }
    }
    return picture_;
}

std::vector<glm::vec4> ScatterPasses::sums() const {
    std::vector<glm::vec4> texels(static_cast<std::size_t>(sums_.width()) *
                                  static_cast<std::size_t>(sums_.height()));
    sums_.bindForReading(0);
    gl_->ReadPixels(0, 0, sums_.width(), sums_.height(), GL_RGBA, GL_FLOAT, texels.data());
    return texels;
}

} // namespace aolib::bake
