#pragma once

#include "backbone/frame/FrameContext.h"
#include "gl/GLSLShader.h"

namespace aolib {

/// Screen-space AO for pixels that no cube map covers
/// (shaders/cubemap/screen_space_fallback.frag): far from the truth, but nearer than white. It
/// costs by the pixels that it shades.
class ScreenSpaceFallback {
public:
    /// Errors: ShaderError.
    static Result<ScreenSpaceFallback> create(const BackboneContext& context);

    /// Whether there is something for it to shade, and it is worth its cost.
    /// @param shaded  share of the surfaces that cube maps shade; -1 before anyone has looked
    /// @param atOnce  cube maps are computed at once, however long that takes
    static bool due(const BackboneContext& context, float shaded, bool atOnce);

    /// Writes W of the pixels that no cube map covers.
    /// @param visibility    of Projection::projectToTexture()
    void fillTexture(const FrameContext& context, const gl::RenderToTexture2D& visibility);
    /// The same into a target as Blur::apply() leaves it, as unshaded as they are.
    /// @param projected  as Projection::apply() gives it
    void fill(const FrameContext& context, const gl::RenderToTexture2D& projected,
              const gl::RenderToTexture2D& visibility);

private:
    void bind(const FrameContext& context);

    gl::GLSLShader visibility_;
};

} // namespace aolib
