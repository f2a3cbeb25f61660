#pragma once

#include <array>
#include <vector>

#include "backbone/cubemaps/CubeMapProjector.h"
#include "backbone/frame/FrameContext.h"
#include "gl/GLSLShader.h"

namespace aolib {

/// Pictures of the view's size that projections leave.
struct ProjectedPictures {
    std::array<gl::RenderToTexture2D, 2> best; ///< Projection::apply()'s, to and fro
    gl::RenderToTexture2D visibility;          ///< Projection::projectToTexture()'s
    gl::RenderToTexture2D upsampled;           ///< of frames with buffers at half resolution

    std::size_t bytes() const;
};

/// The cube maps that are projected onto a view, and what was computed for its own pixels.
struct ProjectedCubeMaps {
    const TexelAtlas& atlas;
    const std::vector<CubeMapProjector*>& list;
    const gl::TextureStack* refined = nullptr; ///< StaticViewRefiner's, of a view at rest
};

/// Projects cube maps onto the host's view (thesis 4.4): best quality wins, close calls are
/// blended.
class Projection {
public:
    /// Errors: ShaderError.
    static Result<Projection> create(const BackboneContext& context);

    /// Sets what shaders/cubemap/projection.glsl and shaders/frame/host_surface.glsl read, on units
    /// 0 to 3 and 5.
    static void bind(gl::GLSLShader& shader, const FrameContext& context,
                     const ProjectedCubeMaps& cubeMaps);

    /// Darkens the host's picture: in a single pass, or two at half resolution. Errors:
    /// OutOfMemory.
    AoStatus shade(const FrameContext& context, const ProjectedCubeMaps& cubeMaps,
                   ProjectedPictures& pictures);

    /// W into a target instead, with a depth that fullscreen passes fail by GL_LESS; -1, and no
    /// such depth, for background and where no cube map covers the surface.
    /// @param withDepth  else the depth is left as it is. Errors: OutOfMemory.
    Result<const gl::RenderToTexture2D*> projectToTexture(const FrameContext& context,
                                                          const ProjectedCubeMaps& cubeMaps,
                                                          ProjectedPictures& pictures,
                                                          bool withDepth);

    /// The same into a target whose texture 0 holds, per pixel, the weighted sum of W, log2 of
    /// quality, the face's code and the weight; in one pass, or to and fro between two targets.
    /// Errors: OutOfMemory.
    Result<const gl::RenderToTexture2D*> apply(const FrameContext& context,
                                               const ProjectedCubeMaps& cubeMaps,
                                               ProjectedPictures& pictures);

private:
    static AoStatus prepare(const BackboneContext& context, const glm::ivec2& size,
                            gl::RenderToTexture2D& target);
    /// Projects at full resolution or half. Errors: OutOfMemory.
    Result<const gl::RenderToTexture2D*> project(const FrameContext& context,
                                                 const ProjectedCubeMaps& cubeMaps,
                                                 ProjectedPictures& pictures);
    /// Binds the shader that gives the host's picture its factors, after what it needs.
    /// Errors: OutOfMemory.
    Result<gl::GLSLShader*> bindShade(const FrameContext& context,
                                      const ProjectedCubeMaps& cubeMaps,
                                      ProjectedPictures& pictures);
    static void bindHalf(gl::GLSLShader& shader, const FrameContext& context,
                         const ProjectedCubeMaps& cubeMaps, const gl::RenderToTexture2D& half);

    /// Without and with pages, without and with refined pixels.
    using Variants = std::array<gl::GLSLShader, 4>;
    static gl::GLSLShader& variant(Variants& shaders, const ProjectedCubeMaps& cubeMaps);

    Variants project_;
    Variants shade_;
    std::array<gl::GLSLShader, 2> shadeHalf_; ///< without and with refined pixels
    std::array<gl::GLSLShader, 2> upsample_;
};

} // namespace aolib
