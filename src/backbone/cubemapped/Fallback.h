#pragma once

#include "backbone/HostFramebuffer.h"
#include "gl/GLSLShader.h"

namespace aolib {

/// Shades what no cube map knows by what is in sight (shaders/cubemap/fallback.frag): far from the
/// truth, but nearer than white. It costs by the pixels that it shades.
class Fallback {
public:
    /// Errors: ShaderError.
    static Result<Fallback> create(const BackboneContext& context);

    /// Whether there is something for it to shade, and it is worth its cost.
    /// @param shaded  share of the surfaces that cube maps shade; -1 before anyone has looked
    /// @param atOnce  cube maps are computed at once, however long that takes
    static bool due(const BackboneContext& context, float shaded, bool atOnce);

    /// Darkens the host's picture by what the cube maps tell, and by what is in sight where that is
    /// nothing.
    /// @param told    as Projection::tell() gives it; filled in
    /// @param radius  world units
    void shade(const BackboneContext& context, const Frame& frame, const HostFramebuffer& host,
               const gl::RenderToTexture2D& told, float radius);
    /// Writes W of such pixels into a target as Blur::apply() leaves it, as unshaded as they are.
    /// @param projected  as Projection::apply() gives it
    void fill(const BackboneContext& context, const Frame& frame, const HostFramebuffer& host,
              const gl::RenderToTexture2D& projected, float radius,
              const gl::RenderToTexture2D& visibility);

private:
    void bind(const BackboneContext& context, const Frame& frame, const HostFramebuffer& host,
              float radius);

    gl::GLSLShader visibility_;
    gl::GLSLShader blend_;
};

} // namespace aolib
