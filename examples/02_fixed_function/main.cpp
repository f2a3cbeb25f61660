// A host as the thesis had it: OpenGL 1 with its matrices and lights, and listings 4.17 and 4.18 as
// they read. Nobody says where the camera looks: that is read from OpenGL.
//
// aolib: 34 lines, between the marks.
#include <optional>

#include <GL/gl.h>
#include <glm/gtc/type_ptr.hpp>

#include "Boxes.h"
#include "Offscreen.h"
#include "Stage.h"

// [aolib]
#include <aolib/aolib.h>
using aolib::AO_TRIANGLES;

std::optional<aolib::AmbientOcclusion> instance; // ends while the context is there

aolib::AmbientOcclusion& AmbientOcclusion() {
    return *instance;
}

void defineScene(const Triangles& scene) { // listing 4.17
    AmbientOcclusion().meshBegin();
    for (const glm::vec3& p : scene.positions) {
        AmbientOcclusion().aoVertex3f(p.x, p.y, p.z);
    }
    AmbientOcclusion().aoBegin(AO_TRIANGLES);
    for (const std::uint32_t index : scene.indices) {
        AmbientOcclusion().aoVertexIndex(index);
    }
    AmbientOcclusion().aoEnd();
    (void)AmbientOcclusion().meshEnd();
}
// [/aolib]

namespace {

void light() {
    const GLfloat above[] = {0.4F, 0.8F, 0.3F, 0.0F};
    const GLfloat white[] = {0.45F, 0.45F, 0.45F, 1.0F};
    const GLfloat ambient[] = {0.5F, 0.5F, 0.5F, 1.0F};
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, ambient);
    glLightfv(GL_LIGHT0, GL_POSITION, above);
    glLightfv(GL_LIGHT0, GL_DIFFUSE, white);
    glColorMaterial(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE);
    for (const GLenum name : {GLenum{GL_LIGHTING}, GLenum{GL_LIGHT0}, GLenum{GL_COLOR_MATERIAL},
                              GLenum{GL_DEPTH_TEST}}) {
        glEnable(name);
    }
}

void drawScene(const Triangles& scene) {
    glClearColor(0.60F, 0.72F, 0.86F, 1.0F);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glBegin(GL_TRIANGLES);
    for (const std::uint32_t index : scene.indices) {
        const bool ground = scene.positions[index].y == 0.0F && scene.normals[index].y > 0.0F;
        ground ? glColor3f(0.86F, 0.84F, 0.80F) : glColor3f(0.93F, 0.72F, 0.52F);
        glNormal3fv(glm::value_ptr(scene.normals[index]));
        glVertex3fv(glm::value_ptr(scene.positions[index]));
    }
    glEnd();
}

} // namespace

int main(int argc, char** argv) {
    const stage::Arguments arguments = stage::parse(argc, argv);
    if (arguments.picture.empty()) {
        return 2;
    }
    const auto context = stage::openContext(aolib::ContextRequest::Profile::Compatibility);
    const Triangles scene = groundWithBoxes();
    const stage::Camera camera = stage::camera();
    const glm::vec3 camera_world_position = camera.eye;
    glViewport(0, 0, stage::kWidth, stage::kHeight);
    glMatrixMode(GL_PROJECTION);
    glLoadMatrixf(glm::value_ptr(camera.projection));
    glMatrixMode(GL_MODELVIEW);
    glLoadMatrixf(glm::value_ptr(camera.view));
    light();
    if (!arguments.ambientOcclusion) {
        drawScene(scene);
    } else {
        // [aolib]
        auto created = aolib::AmbientOcclusion::create(context->loader(),
                                                       {.radius = 1.5F, .frameBudget = 0.0F});
        if (!created) {
            return stage::fail(created.status().message());
        }
        instance.emplace(std::move(*created));
        defineScene(scene);
        AmbientOcclusion().aoDrawBegin(); // listing 4.18
        drawScene(scene);
        AmbientOcclusion().aoDrawEnd(camera_world_position.x, camera_world_position.y,
                                     camera_world_position.z);
        const std::string failure = AmbientOcclusion().lastStatus().message();
        instance.reset();
        if (!failure.empty()) {
            return stage::fail(failure);
        }
        // [/aolib]
    }
    std::vector<std::uint8_t> rgb(3 * static_cast<std::size_t>(stage::kWidth * stage::kHeight));
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, stage::kWidth, stage::kHeight, GL_RGB, GL_UNSIGNED_BYTE, rgb.data());
    return stage::save(arguments.picture, rgb);
}
