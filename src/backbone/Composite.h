#pragma once

#include <aolib/Status.h>

#include "backbone/GeometryBuffer.h"

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
        float radius;                            ///< world units
    };
    void apply(const BackboneContext& context, const Frame& frame, const Inputs& inputs);

private:
    void blend(const BackboneContext& context, const Frame& frame, const Inputs& inputs);
    void show(const BackboneContext& context, const Frame& frame, const Inputs& inputs);

    gl::GLSLShader blend_;
    gl::GLSLShader show_;
};

/// Directs rendering to the host's colour buffer 0 and its viewport, everything else masked off.
void beginHostColours(const BackboneContext& context, const Frame& frame);
/// Multiplies the bound shader's output into the host's colours.
void blendIntoHost(const BackboneContext& context);
/// Undoes what beginHostColours() did to the clean slate.
void endHostColours(const BackboneContext& context);

} // namespace aolib
