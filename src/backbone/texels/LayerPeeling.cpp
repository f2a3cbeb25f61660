#include "backbone/texels/LayerPeeling.h"

#include <array>
#include <utility>

#include "backbone/frame/ShaderLibrary.h"
#include "gl/StateGuard.h"

namespace aolib {

namespace {

constexpr std::array<GLfloat, 4> kNothing{-1.0F, -1.0F, 0.0F, 0.0F};
constexpr std::array<GLfloat, 4> kNone{};

void clear(const gl::Functions& gl, const gl::RenderToTexture2D& target,
           const std::array<GLfloat, 4>& value) {
    const GLfloat deepest = 1.0F;
    target.bindAllAsTargets();
    gl.ClearBufferfv(GL_COLOR, 0, value.data());
    gl.ClearBufferfv(GL_DEPTH, 0, &deepest);
}

void setMarks(gl::GLSLShader& shader, const LayerPeeling::Marks& marks) {
    shader.set("uInside", marks.around);
    shader.set("uInsideCount", static_cast<int>(marks.around.size()));
    shader.set("uUnusual", marks.unusual);
    shader.set("uUnusualCount", static_cast<int>(marks.unusual.size()));
}

} // namespace

Result<LayerPeeling> LayerPeeling::create(const BackboneContext& context) {
    LayerPeeling peeling;
    peeling.gl_ = &context.gl;
    AoStatus status;
    const auto build = [&](gl::GLSLShader& shader, const char* vertex, const char* fragment) {
        if (!status) {
            return;
        }
        auto built = buildShader(context.gl, vertex, fragment);
        status = built.status();
        if (built) {
            shader = std::move(*built);
        }
    };
    build(peeling.sides_, "cubemap/peel.vert", "cubemap/peel_sides.frag");
    build(peeling.count_, "cubemap/peel.vert", "cubemap/count_layers.frag");
    build(peeling.entry_, "cubemap/peel.vert", "cubemap/peel_entry.frag");
    build(peeling.exit_, "cubemap/peel.vert", "cubemap/peel_exit.frag");
    build(peeling.pack_, "fullscreen.vert", "cubemap/pack_interval.frag");
    if (!status) {
        return status;
    }
    return peeling;
}

bool LayerPeeling::drawSides(const FaceCapture& faces, int face,
                             const gl::RenderToTexture2D& sides) {
    clear(*gl_, sides, kNothing);
    sides_.bind();
    return faces.draw(sides_, face);
}

void LayerPeeling::drawCounts(const FaceCapture& faces, int face, const Marks& marks,
                              const gl::RenderToTexture2D& counts) {
    counts.bindAsTarget(0);
    gl_->ClearBufferfv(GL_COLOR, 0, kNone.data());
    gl::beginBlending(*gl_, GL_ONE, GL_ONE, GL_ONE, GL_ONE);
    count_.bind();
    setMarks(count_, marks);
    faces.draw(count_, face);
    gl::endBlending(*gl_);
}

void LayerPeeling::peelEntries(const FaceCapture& faces, int face, const Marks& marks,
                               const gl::RenderToTexture2D* previous,
                               const gl::RenderToTexture2D& exits,
                               const gl::RenderToTexture2D& entries) {
    clear(*gl_, entries, kNothing);
    entry_.bind();
    // The first layer reads neither, but what was bound there before may be drawn to now.
    (previous != nullptr ? *previous : exits).bindTexture(0, 0);
    exits.bindTexture(0, 1);
    entry_.set("uPrevious", 0);
    entry_.set("uExit", 1);
    entry_.set("uFirstLayer", previous == nullptr ? 1 : 0);
    setMarks(entry_, marks);
    faces.draw(entry_, face);
}

void LayerPeeling::peelExits(const FaceCapture& faces, int face, const Marks& marks,
                             const gl::RenderToTexture2D& entries,
                             const gl::RenderToTexture2D& exits) {
    clear(*gl_, exits, kNone);
    exit_.bind();
    entries.bindTexture(0, 0);
    exit_.set("uEntry", 0);
    setMarks(exit_, marks);
    faces.draw(exit_, face);
}

void LayerPeeling::pack(const BackboneContext& context, const gl::RenderToTexture2D& entries,
                        const gl::RenderToTexture2D& exits) {
    pack_.bind();
    entries.bindTexture(0, 0);
    exits.bindTexture(0, 1);
    pack_.set("uEntry", 0);
    pack_.set("uExit", 1);
    context.emptyVertexArray.drawFullscreen();
}

} // namespace aolib
