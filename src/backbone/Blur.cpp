#include "backbone/Blur.h"

#include "backbone/ShaderLibrary.h"
#include "gl/Label.h"

namespace aolib {

Result<Blur> Blur::create(const BackboneContext& context) {
    auto shader = buildShader(context.gl, "fullscreen.vert", "frame/blur.frag");
    if (!shader) {
        return shader.status();
    }
    Blur blur;
    blur.shader_ = std::move(*shader);
    return blur;
}

void Blur::apply(const BackboneContext& context, const Frame& frame, const GeometryBuffer& geometry,
                 const gl::RenderToTexture2D& projected, int size) {
    const gl::DebugGroup group(context.gl, "aolib: blur");
    shader_.bind();
    geometry.bind(shader_, frame, 0, 1);
    projected.bindTexture(0, 2);
    shader_.set("uVisibility", 2);
    shader_.set("uHalfSize", size / 2);
    context.generated.drawFullscreen();
}

} // namespace aolib
