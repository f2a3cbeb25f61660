#include "Guest.h"

#include <stdexcept>
#include <utility>

#include <gtest/gtest.h>

#include "HostObjects.h"
#include "SmallScene.h"
#include "host/ModelScene.h"

namespace aolib {

Options smallOptions() {
    Options options = atOnce();
    options.radius = 2.0F;
    options.horizonSplit = {.directions = 2, .steps = 3};
    options.layeredIntervals = {.slices = 1, .steps = 3, .layers = 2};
    options.rayTraced.rays = 4;
    options.cubeMaps.faceSize = 16;
    options.cubeMaps.nearest = 3;
    return options;
}

Model guestScene() {
    Model model;
    addQuad(model, {-10, 0, -10}, {-10, 0, 10}, {10, 0, 10}, {10, 0, -10});
    addBox(model, {-2, 0, -2}, {0, 2, 0});
    addBox(model, {0.5F, 0, -1}, {2, 1, 1});
    return model;
}

const glm::mat4& Guest::view() {
    static const glm::mat4 matrix = glm::lookAt(eye(), glm::vec3(0, 0.5F, 0), glm::vec3(0, 1, 0));
    return matrix;
}
const glm::mat4& Guest::projection() {
    static const glm::mat4 matrix =
        glm::perspective(glm::radians(60.0F), 16.0F / 9.0F, 0.1F, 100.0F);
    return matrix;
}
const glm::vec3& Guest::eye() {
    static const glm::vec3 position(3, 3, 5);
    return position;
}

Guest::Guest(const ProcAddressLoader& loader, const gl::Functions& gl)
    : loader_(loader), hostile_(gl) {
    makeTextures(gl);
    ao_.emplace(std::move(*AmbientOcclusion::create(loader, smallOptions())));
    empty_.emplace(std::move(*AmbientOcclusion::create(loader, smallOptions())));
    meshes_ = *host::describeScene(*ao_, guestScene(), host::SceneNormals::Geometric);
    EXPECT_TRUE(ao_->aoSetCamera(view(), projection()).ok());
    drawn_.emplace(std::move(*AmbientOcclusion::create(loader, smallOptions())));
    EXPECT_TRUE(drawn_->aoSetCamera(view(), projection()).ok());
    const auto renderer = [this](const FaceView& face) {
        hostile_(face);
        if (throws_) {
            throw std::runtime_error("as agreed");
        }
    };
    EXPECT_TRUE(drawn_->setSceneRenderer(renderer, {-10, 0, -10}, {10, 2, 10}).ok());
}

void Guest::makeTextures(const gl::Functions& gl) {
    constexpr GLsizei kWidth = HostObjects::kWidth;
    constexpr GLsizei kHeight = HostObjects::kHeight;
    struct Format {
        GLint internal;
        GLenum format;
        GLenum type;
    };
    for (const Format& f : {Format{GL_DEPTH24_STENCIL8, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8},
                            Format{GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE},
                            Format{GL_RGB10_A2, GL_RGBA, GL_UNSIGNED_BYTE}}) {
        textures_.push_back(gl::generate<gl::Texture>(gl, &gl::Functions::GenTextures));
        gl.BindTexture(GL_TEXTURE_2D, textures_.back().name());
        const std::vector<GLuint> half(static_cast<std::size_t>(kWidth * kHeight), 0x7F7F7F7FU);
        gl.TexImage2D(GL_TEXTURE_2D, 0, f.internal, kWidth, kHeight, 0, f.format, f.type,
                      half.data());
    }
    gl.BindTexture(GL_TEXTURE_2D, 0);
}

} // namespace aolib
