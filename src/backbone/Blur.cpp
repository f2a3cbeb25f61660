#include "backbone/Blur.h"

#include <utility>

#include "backbone/ShaderLibrary.h"
#include "gl/Label.h"

namespace aolib {

Result<Blur> Blur::create(const BackboneContext& context) {
    auto rows = buildShader(context.gl, "fullscreen.vert", "frame/blur_rows.frag");
    if (!rows) {
        return rows.status();
    }
    auto columns = buildShader(context.gl, "fullscreen.vert", "frame/blur.frag");
    if (!columns) {
        return columns.status();
    }
    Blur blur;
    blur.rows_ = std::move(*rows);
    blur.columns_ = std::move(*columns);
    return blur;
}

AoStatus Blur::apply(const BackboneContext& context, const Frame& frame,
                     const GeometryBuffer& geometry, const gl::RenderToTexture2D& projected,
                     int size, gl::RenderToTexture2D& rows, const gl::RenderToTexture2D& target) {
    const gl::DebugGroup group(context.gl, "aolib: blur");
    if (AoStatus status =
            rows.become(context.gl, {.width = frame.size.x,
                                     .height = frame.size.y,
                                     .targets = {gl::RenderToTexture2D::Format::RG32F},
                                     .label = "aolib/frame/rows"});
        !status) {
        return status;
    }
    const auto draw = [&](gl::GLSLShader& shader, const gl::RenderToTexture2D& into) {
        into.begin(0);
        shader.bind();
        geometry.bind(shader, frame, 0, 1);
        projected.bindTexture(0, 2);
        shader.set("uVisibility", 2);
        shader.set("uHalfSize", size / 2);
        context.generated.drawFullscreen();
    };
    draw(rows_, rows);
    rows.bindTexture(0, 3);
    columns_.bind();
    columns_.set("uRows", 3);
    draw(columns_, target);
    return {};
}

} // namespace aolib
