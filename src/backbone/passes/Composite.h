#pragma once

#include <optional>

#include <aolib/Status.h>

#include "backbone/frame/FrameContext.h"
#include "backbone/passes/GeometryBuffer.h"

namespace aolib {

/// The last pass: onto the host's own framebuffer, multiplied into its colours or as a debug view.
class Composite {
public:
    /// Errors: ShaderError.
    static Result<Composite> create(const BackboneContext& context);

    struct Inputs {
        const GeometryBuffer& geometry;
        const gl::RenderToTexture2D& visibility; ///< as Blur::apply() wrote it
        const gl::RenderToTexture2D& projected;  ///< before the blur
    };
    /// Errors: ShaderError.
    AoStatus apply(const FrameContext& context, const Inputs& inputs);
    /// Multiplies the host's colours by W: every sample by its own where the host has several.
    /// @param visibility  W; -1 for background and where nothing is known. Errors: ShaderError.
    AoStatus blend(const FrameContext& context, const gl::RenderToTexture2D& visibility);
    /// Writes W to the target that is bound, the mean of a pixel's samples, background counting as
    /// 1. Pixels that show background alone stay as they are. Errors: ShaderError.
    AoStatus writeMeans(const FrameContext& context, const gl::RenderToTexture2D& visibility);

private:
    AoStatus buildSampled(const gl::Functions& gl);
    /// Draws the factors of all pixels, but of those with several surfaces.
    void drawPixels(const FrameContext& context, const gl::RenderToTexture2D& visibility,
                    const glm::ivec2& origin, float contrast);
    /// Draws the factors of pixels with several surfaces.
    /// @param each  sample by sample; else their mean
    void drawEdges(const FrameContext& context, const gl::RenderToTexture2D& visibility,
                   const glm::ivec2& origin, float contrast, bool each);
    void show(const FrameContext& context, const Inputs& inputs);

    gl::GLSLShader blend_;
    gl::GLSLShader show_;
    std::optional<gl::GLSLShader> blendInner_;   ///< without pixels with several surfaces, and ...
    std::optional<gl::GLSLShader> blendSamples_; ///< ... those; built for the first such host
};

/// Directs rendering to the host's colour buffer 0 and its viewport, everything else visibility
/// off.
void beginHostColours(const FrameContext& context);
/// Multiplies what is drawn into the host's colours, from here to endBlend().
void beginBlend(const BackboneContext& context);
void endBlend(const BackboneContext& context);
/// Multiplies the bound shader's output into the host's colours.
void blendIntoHost(const BackboneContext& context);
/// Undoes what beginHostColours() did to the known GL state.
void endHostColours(const BackboneContext& context);

} // namespace aolib
