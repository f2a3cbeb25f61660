#include "RenderedScene.h"

#include <utility>

#include <gtest/gtest.h>

#include "content/generated/GeneratedScenes.h"

namespace aolib::test {

namespace {

/// More frames than any view needs: one to place, one to count coverage, and the readback's delay.
constexpr int kMostFrames = 8;

} // namespace

Model buildScene(const SceneView& view) {
    return findGeneratedScene(view.scene)->build();
}

NamedCamera cameraOf(const SceneView& view) {
    for (const NamedCamera& camera : findGeneratedScene(view.scene)->cameras()) {
        if (camera.name == view.camera) {
            return camera;
        }
    }
    ADD_FAILURE() << view.scene << " has no camera " << view.camera;
    return {};
}

RenderedScene::RenderedScene(const gl::Functions& gl, const ProcAddressLoader& loader,
                             const Model& model, const Options& options, int width, int height,
                             host::SceneNormals normals)
    : width_(width), height_(height) {
    auto ao = AmbientOcclusion::create(loader, options);
    auto framebuffer = host::HostFramebuffer::create(gl, {width, height, /*samples=*/0});
    auto renderer = host::HostRenderer::create(gl, model);
    if (!ao || !framebuffer || !renderer) {
        ADD_FAILURE() << ao.status().message() << framebuffer.status().message()
                      << renderer.status().message();
        return;
    }
    const auto meshes = host::describeScene(*ao, model, normals);
    EXPECT_TRUE(meshes.ok()) << meshes.status().message();
    ao_.emplace(std::move(*ao));
    framebuffer_.emplace(std::move(*framebuffer));
    renderer_.emplace(std::move(*renderer));
}

AoStatus RenderedScene::frame(const NamedCamera& camera) {
    const glm::mat4 view = viewMatrix(camera);
    const glm::mat4 projection =
        projectionMatrix(camera, static_cast<float>(width_) / static_cast<float>(height_));
    framebuffer_->bind();
    if (AoStatus status = ao_->aoSetCamera(view, projection); !status) {
        return status;
    }
    if (AoStatus status = ao_->aoDrawBegin(); !status) {
        return status;
    }
    renderer_->draw(view, projection);
    return ao_->aoDrawEnd(camera.eye.x, camera.eye.y, camera.eye.z);
}

AoStatus RenderedScene::settle(const NamedCamera& camera) {
    for (int i = 0; i < kMostFrames; ++i) {
        if (AoStatus status = frame(camera); !status) {
            return status;
        }
        const Statistics statistics = ao_->statistics();
        if (i > 0 && statistics.cubeMapsBuilt == 0 && statistics.coverage >= 0.0F) {
            break;
        }
    }
    return {};
}

FloatImage RenderedScene::visibility() {
    Result<VisibilityImage> image = ao_->readVisibility();
    EXPECT_TRUE(image.ok()) << image.status().message();
    FloatImage picture;
    if (image) {
        picture = FloatImage(image->width, image->height, 1);
        picture.pixels = std::move(image->visibility);
    }
    return picture;
}

ByteImage RenderedScene::composite() {
    Result<ByteImage> picture = framebuffer_->readColour();
    EXPECT_TRUE(picture.ok()) << picture.status().message();
    return picture ? std::move(*picture) : ByteImage();
}

} // namespace aolib::test
