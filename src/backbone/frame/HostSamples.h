#pragma once

#include <optional>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <aolib/Status.h>

#include "backbone/frame/Frame.h"
#include "gl/GLSLShader.h"
#include "gl/MultisampleDepth.h"
#include "gl/RenderToTexture2D.h"

namespace aolib {

/// The samples of a multisampled host's depth: one depth per pixel of them for the passes that read
/// no samples, and which pixels show several surfaces.
class HostSamples {
public:
    /// Texture unit of the samples themselves; no pass binds anything else to it.
    static constexpr int kUnit = 7;

    /// Whether this many samples can be copied.
    static bool canCopy(const gl::Functions& gl, int samples);

    /// Copies the viewport's part of the samples, and finds one depth per pixel. Leaves a
    /// framebuffer of its own bound. Where the driver has no texture with that many samples,
    /// count() is 0. Errors: OutOfMemory, MissingCapability, ShaderError.
    AoStatus acquire(const BackboneContext& context, const Frame& frame,
                     gl::RenderToTexture2D::Depth format, int samples);

    int count() const { return static_cast<int>(places_.size()); }
    /// Where a sample lies in a pixel, 0 to 1.
    glm::vec2 place(std::size_t sample) const { return glm::vec2(places_[sample]); }

    /// One depth per pixel.
    void bindDepth(int unit) const { resolved_.bindTexture(0, unit); }
    /// Which pixels show several surfaces, as shaders/frame/resolve_edges.frag writes it.
    void bindEdges(int unit) const { resolved_.bindTexture(1, unit); }
    /// Sets the uniforms of shaders/frame/host_samples.glsl but the view's.
    void setUniforms(gl::GLSLShader& shader) const;
    gl::MultisampleBinding bindSamples(const gl::Functions& gl) const {
        return {gl, samples_.textureName(), kUnit};
    }
    /// Draws the tiles that have such pixels with a shader of shaders/frame/edge_tiles.vert.
    /// @param unit  that it may bind a texture to
    void drawTiles(const BackboneContext& context, gl::GLSLShader& shader, int unit) const;

    std::size_t bytes() const;

private:
    AoStatus buildShaders(const gl::Functions& gl);
    AoStatus makeTargets(const gl::Functions& gl, const glm::ivec2& size,
                         gl::RenderToTexture2D::Depth format, int samples);
    void readPlaces(const gl::Functions& gl, int samples);
    void resolve(const BackboneContext& context, const Frame& frame);
    void bindToResolve(const Frame& frame, gl::GLSLShader& shader) const;

    std::optional<gl::GLSLShader> resolve_;
    std::optional<gl::GLSLShader> findTiles_;
    std::optional<gl::GLSLShader> resolveEdges_;
    std::vector<glm::vec4> places_; ///< x, y of each
    gl::MultisampleDepth samples_;
    gl::RenderToTexture2D resolved_; ///< depth; edges
    gl::RenderToTexture2D tiles_;
};

} // namespace aolib
