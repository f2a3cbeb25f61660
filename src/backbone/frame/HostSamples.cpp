#include "backbone/frame/HostSamples.h"

#include <algorithm>
#include <array>
#include <string>

#include <glm/common.hpp>

#include "backbone/frame/ShaderLibrary.h"
#include "gl/Label.h"

namespace aolib {

namespace {

/// Pixels along the edge of a tile that is drawn, or left out, as a whole.
constexpr int kTileSize = 8;
/// Vertices of a tile's two triangles.
constexpr int kTileVertices = 6;
constexpr int kFoundEdgesUnit = 0;

} // namespace

bool HostSamples::canCopy(const gl::Functions& gl, int samples) {
    GLint most = 0;
    gl.GetIntegerv(GL_MAX_DEPTH_TEXTURE_SAMPLES, &most);
    return samples > 1 && samples <= std::min(most, gl::SampleMask::kMostSamples);
}

AoStatus HostSamples::buildShaders(const gl::Functions& gl) {
    AoStatus status;
    const auto build = [&](std::optional<gl::GLSLShader>& shader, const char* vertex,
                           const char* fragment) {
        if (status && !shader) {
            auto built = buildShader(gl, vertex, fragment);
            status = built.status();
            if (built) {
                shader = std::move(*built);
            }
        }
    };
    build(resolve_, "fullscreen.vert", "frame/resolve_samples.frag");
    build(findTiles_, "fullscreen.vert", "frame/edge_tiles.frag");
    build(resolveEdges_, "frame/edge_tiles.vert", "frame/resolve_edges.frag");
    return status;
}

AoStatus HostSamples::makeTargets(const gl::Functions& gl, const glm::ivec2& size,
                                  gl::RenderToTexture2D::Depth format, int samples) {
    using Format = gl::RenderToTexture2D::Format;
    using Filter = gl::RenderToTexture2D::Filter;
    AoStatus status = samples_.reset(gl, {.width = size.x,
                                          .height = size.y,
                                          .samples = samples,
                                          .format = format,
                                          .label = "aolib/frame/samples"});
    if (status) {
        status = resolved_.reset(gl, {.width = size.x,
                                      .height = size.y,
                                      .targets = {Format::R32F, Format::R8},
                                      .minFilter = Filter::Linear,
                                      .magFilter = Filter::Linear,
                                      .label = "aolib/frame/resolved"});
    }
    const glm::ivec2 tiles = (size + kTileSize - 1) / kTileSize;
    if (status) {
        status = tiles_.reset(gl, {.width = tiles.x,
                                   .height = tiles.y,
                                   .targets = {Format::R8},
                                   .label = "aolib/frame/edge tiles"});
    }
    return status;
}

/// Of the framebuffer that is bound for drawing.
void HostSamples::readPlaces(const gl::Functions& gl, int samples) {
    for (int i = 0; i < samples; ++i) {
        std::array<GLfloat, 2> place{};
        gl.GetMultisamplefv(GL_SAMPLE_POSITION, static_cast<GLuint>(i), place.data());
        places_.emplace_back(place[0], place[1], 0.0F, 0.0F);
    }
}

AoStatus HostSamples::acquire(const BackboneContext& context, const Frame& frame,
                              gl::RenderToTexture2D::Depth format, int samples) {
    const gl::Functions& gl = context.gl;
    const gl::DebugGroup group(gl, "aolib: samples of the depth");
    if (AoStatus status = buildShaders(gl); !status) {
        return status;
    }
    if (AoStatus status = makeTargets(gl, frame.size, format, samples); !status) {
        return status;
    }
    places_.clear();
    if (samples_.samples() != samples) {
        return {}; // a blit needs as many
    }
    gl.BindFramebuffer(GL_FRAMEBUFFER, frame.depthFramebuffer);
    readPlaces(gl, samples);
    samples_.beginDraw();
    const glm::ivec2 o = frame.origin;
    const glm::ivec2 s = frame.size;
    gl.BlitFramebuffer(o.x, o.y, o.x + s.x, o.y + s.y, 0, 0, s.x, s.y, GL_DEPTH_BUFFER_BIT,
                       GL_NEAREST);
    resolve(context, frame);
    return {};
}

void HostSamples::setUniforms(gl::GLSLShader& shader) const {
    shader.set("uSamples", kUnit);
    shader.set("uSampleAt", places_);
}

/// Binds a shader that finds one depth per pixel.
void HostSamples::bindToResolve(const Frame& frame, gl::GLSLShader& shader) const {
    resolved_.bindAllAsTargets();
    shader.bind();
    setUniforms(shader);
    shader.set("uSampleCount", count());
    frame.camera.setUniforms(shader, frame.size, frame.clip);
}

void HostSamples::resolve(const BackboneContext& context, const Frame& frame) {
    const gl::MultisampleBinding binding = bindSamples(context.gl);
    bindToResolve(frame, *resolve_);
    context.emptyVertexArray.drawFullscreen();
    tiles_.bindAsTarget(0);
    findTiles_->bind();
    bindEdges(kFoundEdgesUnit);
    findTiles_->set("uEdges", kFoundEdgesUnit);
    findTiles_->set("uTileSize", kTileSize);
    context.emptyVertexArray.drawFullscreen();
    bindToResolve(frame, *resolveEdges_);
    drawTiles(context, *resolveEdges_, kFoundEdgesUnit);
}

void HostSamples::drawTiles(const BackboneContext& context, gl::GLSLShader& shader,
                            int unit) const {
    tiles_.bindTexture(0, unit);
    shader.set("uTiles", unit);
    shader.set("uTileSize", kTileSize);
    context.emptyVertexArray.drawGenerated(GL_TRIANGLES,
                                           kTileVertices * tiles_.width() * tiles_.height());
}

std::size_t HostSamples::bytes() const {
    return samples_.bytes() + (resolved_ ? resolved_.bytes() : 0) + (tiles_ ? tiles_.bytes() : 0);
}

} // namespace aolib
