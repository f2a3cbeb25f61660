#include "backbone/passes/Blur.h"

#include <utility>

#include "backbone/frame/ShaderLibrary.h"
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

AoStatus Blur::apply(const FrameContext& context, const GeometryBuffer& geometry,
                     const gl::RenderToTexture2D& projected, int size, BlurredPictures& into) {
    const gl::DebugGroup group(context.gl, "aolib: blur");
    const auto makeTarget = [&](gl::RenderToTexture2D& target, const char* label) {
        return target.reset(context.gl, {.width = context.frame.size.x,
                                         .height = context.frame.size.y,
                                         .targets = {gl::RenderToTexture2D::Format::RG32F},
                                         .label = label});
    };
    if (AoStatus status = makeTarget(into.visibility, "aolib/frame/visibility"); !status) {
        return status;
    }
    if (AoStatus status = makeTarget(into.rows, "aolib/frame/rows"); !status) {
        return status;
    }
    const auto draw = [&](gl::GLSLShader& shader, const gl::RenderToTexture2D& target) {
        target.bindAsTarget(0);
        shader.bind();
        geometry.bind(shader, context.frame, 0, 1);
        projected.bindTexture(0, 2);
        shader.set("uVisibility", 2);
        shader.set("uHalfSize", size / 2);
        context.emptyVertexArray.drawFullscreen();
    };
    draw(rows_, into.rows);
    into.rows.bindTexture(0, 3);
    columns_.bind();
    columns_.set("uRows", 3);
    draw(columns_, into.visibility);
    return {};
}

} // namespace aolib
