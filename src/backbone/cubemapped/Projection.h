#pragma once

#include <array>
#include <vector>

#include "backbone/HostFramebuffer.h"
#include "backbone/cubemapped/CubeMapProjector.h"
#include "gl/GLSLShader.h"

namespace aolib {

/// What all cube maps keep, and what was traced for the view.
struct KeptTexels {
    const FaceStore& faces;
    const DetailStore& details;
    const gl::TextureStack* repaired = nullptr; ///< ViewRepair's, of the view at rest
};

/// Projects cube maps onto the host's view (thesis 4.4): best quality wins, close calls are
/// blended.
class Projection {
public:
    /// Errors: ShaderError.
    static Result<Projection> create(const BackboneContext& context);

    /// Sets what shaders/cubemap/projection.glsl and shaders/frame/host_surface.glsl read, on units
    /// 0 to 3 and 5.
    static void bind(gl::GLSLShader& shader, const Frame& frame, const HostFramebuffer& host,
                     const KeptTexels& kept, const std::vector<CubeMapProjector*>& projectors);

    /// Darkens the host's picture in a single pass.
    void shade(const BackboneContext& context, const Frame& frame, const HostFramebuffer& host,
               const KeptTexels& kept, const std::vector<CubeMapProjector*>& projectors);

    /// The same into a target whose texture 0 holds, per pixel, the weighted sum of W, log2 of
    /// quality, the face's code and the weight; in one pass, or to and fro between two targets.
    /// Errors: OutOfMemory.
    Result<const gl::RenderToTexture2D*> apply(const BackboneContext& context, const Frame& frame,
                                               const HostFramebuffer& host, const KeptTexels& kept,
                                               const std::vector<CubeMapProjector*>& projectors);
    std::size_t bytes() const;

private:
    Status prepare(const BackboneContext& context, const Frame& frame,
                   gl::RenderToTexture2D& target);

    /// Without and with detail, without and with repaired pixels.
    using Variants = std::array<gl::GLSLShader, 4>;
    static gl::GLSLShader& variant(Variants& shaders, const KeptTexels& kept);

    Variants project_;
    Variants shade_;
    std::array<gl::RenderToTexture2D, 2> best_;
};

} // namespace aolib
