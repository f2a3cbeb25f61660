#include "backbone/passes/GeometryBuffer.h"

#include "backbone/frame/ShaderLibrary.h"
#include "gl/Label.h"

namespace aolib {

Result<GeometryPass> GeometryPass::create(const BackboneContext& context) {
    auto shader = buildShader(context.gl, "fullscreen.vert", "frame/geometry_buffer.frag");
    if (!shader) {
        return shader.status();
    }
    GeometryPass pass;
    pass.shader_ = std::move(*shader);
    return pass;
}

AoStatus GeometryPass::update(const FrameContext& context, GeometryBuffer& buffer) {
    using Format = gl::RenderToTexture2D::Format;
    const gl::DebugGroup group(context.gl, "aolib: geometry buffer");
    gl::RenderToTexture2D& target = buffer.target_;
    if (AoStatus status = target.reset(context.gl, {.width = context.frame.size.x,
                                                    .height = context.frame.size.y,
                                                    .targets = {Format::R32F, Format::RG16F},
                                                    .label = "aolib/frame/geometry"});
        !status) {
        return status;
    }
    if (context.frame.hostNormals && !withNormals_) {
        auto shader = buildShader(context.gl, "fullscreen.vert", "frame/geometry_buffer.frag",
                                  {"AO_HOST_NORMALS"});
        if (!shader) {
            return shader.status();
        }
        withNormals_ = std::move(*shader);
    }
    gl::GLSLShader& shader = context.frame.hostNormals ? *withNormals_ : shader_;
    target.bindAllAsTargets();
    context.host.bindDepth(0);
    shader.bind();
    shader.set("uDepth", 0);
    if (context.frame.hostNormals) {
        context.host.bindNormals(1);
        shader.set("uHostNormals", 1);
        shader.set("uNormalCode", context.host.normalCode());
    }
    context.frame.camera.setUniforms(shader, context.frame.size, context.frame.clip);
    context.emptyVertexArray.drawFullscreen();
    return {};
}

void GeometryBuffer::bind(gl::GLSLShader& shader, const Frame& frame, int depthUnit,
                          int normalUnit) const {
    target_.bindTexture(0, depthUnit);
    target_.bindTexture(1, normalUnit);
    shader.set("uLinearDepth", depthUnit);
    shader.set("uNormal", normalUnit);
    frame.camera.setUniforms(shader, frame.size, frame.clip);
}

} // namespace aolib
