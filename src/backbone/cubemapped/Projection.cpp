#include "backbone/cubemapped/Projection.h"

#include <utility>

#include "backbone/ShaderLibrary.h"
#include "gl/Label.h"

namespace aolib {

Result<Projection> Projection::create(const BackboneContext& context) {
    auto shader = buildShader(context.gl, "fullscreen.vert", "cubemap/project.frag");
    if (!shader) {
        return shader.status();
    }
    Projection projection;
    projection.shader_ = std::move(*shader);
    return projection;
}

Result<const gl::RenderToTexture2D*>
Projection::apply(const BackboneContext& context, const Frame& frame,
                  const GeometryBuffer& geometry, const std::vector<CubeMapProjector*>& projectors,
                  float unshaded) {
    const gl::DebugGroup group(context.gl, "aolib: project cube maps");
    for (gl::RenderToTexture2D& target : best_) {
        if (target && target.width() == frame.size.x && target.height() == frame.size.y) {
            continue;
        }
        auto created = gl::RenderToTexture2D::create(
            context.gl, {.width = frame.size.x,
                         .height = frame.size.y,
                         .targets = {gl::RenderToTexture2D::Format::RG16F},
                         .label = "aolib/frame/best"});
        if (!created) {
            return created.status();
        }
        target = std::move(*created);
    }
    const gl::RenderToTexture2D* best = &best_[0];
    const gl::RenderToTexture2D* next = &best_[1];
    const std::array<GLfloat, 4> nothing{1.0F, unshaded, 0.0F, 0.0F};
    best->begin(0);
    context.gl.ClearBufferfv(GL_COLOR, 0, nothing.data());
    shader_.bind();
    geometry.bind(shader_, frame, 0, 1);
    shader_.set("uBest", 2);
    shader_.set("uShowFaces", context.options.debugView == DebugView::Faces ? 1 : 0);
    for (const CubeMapProjector* projector : projectors) {
        next->begin(0);
        best->bindTexture(0, 2);
        projector->bind(shader_, 3, 4);
        shader_.set("uCubeToEye",
                    glm::vec3(frame.camera.eye() - glm::dvec3(projector->position())));
        context.generated.drawFullscreen();
        std::swap(best, next);
    }
    return best;
}

} // namespace aolib
