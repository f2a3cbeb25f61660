#include "bake/ScatterPasses.h"

#include <algorithm>
#include <array>
#include <utility>

#include <glm/gtc/type_ptr.hpp>

#include "bake/BakeShaders.h"
#include "gl/Label.h"
#include "raytracing/SobolSequence.h"

namespace aolib::bake {

namespace {

using Format = gl::RenderToTexture2D::Format;
using Depth = gl::RenderToTexture2D::Depth;

/// Points per draw call. A software rasteriser keeps the vertices of a call in memory that it asks
/// the system for each time, where they are many: a seventh of its time, with all in one call.
constexpr int pointsAtOnce = 1024;

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
                                            const std::vector<float>& facets) {
    ScatterPasses passes;
    passes.gl_ = &gl;
    passes.settings_ = settings;
    Status status;
    const auto keep = [&](auto& place, auto result) {
        if (status) {
            status = result.status();
        }
        if (result) {
            place = std::move(*result);
        }
    };
    keep(passes.surfaceShader_,
         buildBakeShader(gl, "bake/scatter_surface.vert", "bake/scatter_surface.frag"));
    keep(passes.chartShader_, buildBakeShader(gl, "bake/chart.vert", "bake/chart.frag"));
    keep(passes.pointShader_,
         buildBakeShader(gl, "bake/scatter_point.vert", "bake/scatter_point.frag"));
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
    const MapStack& stack = settings.stack;
    const glm::ivec2 size(stack.mapSize.x, stack.mapSize.y * stack.count);
    keep(passes.surface_, target(glm::ivec2(settings.rasterSize), {Format::RGBA32F, Format::RG16F},
                                 Depth::Depth32F, "aolib/bake/surface"));
    keep(passes.sums_, target(size, {Format::RGBA32F}, Depth::None, "aolib/bake/sums"));
    keep(passes.coverage_, target(size, {Format::RGBA32F}, Depth::None, "aolib/bake/coverage"));
    keep(passes.facets_,
         gl::TextureStack::create(gl, {size.x, size.y, 1, Format::R32F, "aolib/bake/facets"}));
    keep(passes.points_, gl::VertexArray::createEmpty(gl, "aolib/bake/points"));
    if (!status) {
        return status;
    }
    passes.facets_.upload(0, {0, 0}, size, facets.data());
    passes.clear(passes.sums_);
    passes.clear(passes.coverage_);
    return passes;
}

void ScatterPasses::clear(const gl::RenderToTexture2D& target) const {
    target.begin(0);
    const glm::vec4 nothing(0.0F);
    gl_->ClearBufferfv(GL_COLOR, 0, glm::value_ptr(nothing));
}

void ScatterPasses::clearSurface() const {
    surface_.beginAll();
    const glm::vec4 nothing(0.0F);
    gl_->ClearBufferfv(GL_COLOR, 0, glm::value_ptr(nothing));
    gl_->ClearBufferfv(GL_COLOR, 1, glm::value_ptr(nothing));
}

void ScatterPasses::setStack(gl::GLSLShader& shader) const {
    shader.set("uMapSize", glm::vec2(settings_.stack.mapSize));
    shader.set("uFirstMap", settings_.stack.first);
    shader.set("uMapCount", settings_.stack.count);
    shader.set("uPixelSize", pictureSide / float(settings_.rasterSize));
}

// Places are Sobol's, whose projections onto both axes are evenly spaced. So a texel that is
// covered as a whole has an exact sum, and one that a border along an axis cuts is off by less than
// 1 / count.
void ScatterPasses::addCoverage(const BakeVertices& vertices, int first, int last, int count) {
    const gl::DebugGroup group(*gl_, "aolib/bake/coverage");
    const int tile =
        std::min(settings_.rasterSize, std::max(coverage_.width(), coverage_.height()));
    for (auto i = static_cast<std::uint32_t>(first); i < static_cast<std::uint32_t>(last); ++i) {
        const glm::vec2 place = glm::vec2(bitReversed(i), bitReversed(sobolSecond(i))) * 0x1p-32F;
        for (int y = 0; y < coverage_.height(); y += tile) {
            for (int x = 0; x < coverage_.width(); x += tile) {
                clearSurface();
                gl_->Viewport(0, 0, tile, tile);
                chartShader_.bind();
                setStack(chartShader_);
                // A pixel's centre is to lie at `place` in its texel.
                chartShader_.set("uTileOrigin", glm::vec2(x, y) + place - 0.5F);
                chartShader_.set("uTileSize", float(tile));
                chartShader_.set("uSampleArea", 1.0F / float(count));
                vertices.draw();
                scatter(coverage_, glm::vec3(0.0F),
                        {tile, std::min(tile, coverage_.height() - y + 1)});
            }
        }
    }
}

void ScatterPasses::addDirection(const BakeVertices& vertices, const LightView& view) {
    const gl::DebugGroup group(*gl_, "aolib/bake/direction");
    clearSurface();
    const float farthest = 1.0F;
    gl_->ClearBufferfv(GL_DEPTH, 0, &farthest);
    gl_->Enable(GL_DEPTH_TEST);
    surfaceShader_.bind();
    setStack(surfaceShader_);
    surfaceShader_.set("uToLight", view.toClip);
    surfaceShader_.set("uDirection", glm::vec3(view.direction));
    surfaceShader_.set("uGround", settings_.ground);
    surfaceShader_.set("uDensity", settings_.density);
    vertices.draw();
    gl_->Disable(GL_DEPTH_TEST);
    scatter(sums_, glm::vec3(view.direction), glm::ivec2(settings_.rasterSize));
}

/// Stage 2: adds what lies in the lower left of the picture of stage 1 to a target.
void ScatterPasses::scatter(const gl::RenderToTexture2D& target, const glm::vec3& direction,
                            const glm::ivec2& size) {
    const ShaderPoints points(*gl_);
    target.begin(0);
    surface_.bindTexture(0, 0);
    surface_.bindTexture(1, 1);
    pointShader_.bind();
    pointShader_.set("uSize", 1);
    pointShader_.set("uSurface", 0);
    pointShader_.set("uTargetSize", glm::vec2(target.width(), target.height()));
    facets_.bind(2);
    pointShader_.set("uFacets", 2);
    pointShader_.set("uPointSize", settings_.pointSize);
    pointShader_.set("uDirection", direction);
    gl_->Enablei(GL_BLEND, 0);
    gl_->BlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
    pointShader_.set("uWidth", size.x);
    const int count = size.x * size.y;
    for (int first = 0; first < count; first += pointsAtOnce) {
        points_.drawGenerated(GL_POINTS, std::min(pointsAtOnce, count - first), first);
    }
    gl_->Disablei(GL_BLEND, 0);
}

std::vector<glm::vec4> ScatterPasses::read(const gl::RenderToTexture2D& target) const {
    std::vector<glm::vec4> texels(static_cast<std::size_t>(target.width()) *
                                  static_cast<std::size_t>(target.height()));
    target.beginRead(0);
    gl_->ReadPixels(0, 0, target.width(), target.height(), GL_RGBA, GL_FLOAT, texels.data());
    return texels;
}

} // namespace aolib::bake
