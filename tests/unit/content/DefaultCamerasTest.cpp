#include "content/DefaultCameras.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include "Proximity.h"
#include "content/ModelFile.h"
#include "content/SceneSource.h"

namespace aolib {
namespace {

/// A box of a given half size about a centre.
Model boxModel(const glm::vec3& centre, const glm::vec3& half) {
    ModelMesh mesh;
    for (int corner = 0; corner < 8; ++corner) {
        mesh.positions.push_back(centre + half * glm::vec3((corner & 1) != 0 ? 1 : -1,
                                                           (corner & 2) != 0 ? 1 : -1,
                                                           (corner & 4) != 0 ? 1 : -1));
    }
    mesh.indices = {0, 1, 2, 1, 3, 2, 4, 6, 5, 5, 6, 7, 0, 4, 1, 1, 4, 5};
    return {"box", {mesh}};
}

TEST(DefaultCamerasTest, UnknownModelsAreFramedWhole) {
    for (const glm::vec3& half :
         {glm::vec3(1, 1, 1), glm::vec3(100, 1, 3), glm::vec3(0.01F, 5, 0.02F)}) {
        const Model model = boxModel({7, -3, 20}, half);
        const std::vector<NamedCamera> cameras = defaultCameras(model);
        ASSERT_EQ(cameras.size(), 2U);
        for (const NamedCamera& camera : cameras) {
            const glm::mat4 clip = projectionMatrix(camera, 1.6F) * viewMatrix(camera);
            float widest = 0.0F;
            for (const glm::vec3& p : model.meshes[0].positions) {
                const glm::vec4 c = clip * glm::vec4(p, 1.0F);
                EXPECT_GT(c.w, 0.0F);
                EXPECT_LE(std::abs(c.x), c.w);
                EXPECT_LE(std::abs(c.y), c.w);
                EXPECT_LE(std::abs(c.z), c.w);
                widest = std::max({widest, std::abs(c.x / c.w), std::abs(c.y / c.w)});
            }
            EXPECT_GT(widest, 0.5F) << "the model is lost in the picture";
        }
    }
}

TEST(DefaultCamerasTest, ANameAloneDoesNotMakeAKnownModel) {
    Model model = boxModel({0, 0, 0}, {1, 1, 1});
    model.name = "cloister";
    EXPECT_EQ(defaultCameras(model)[0].name, "front right");
}

TEST(DefaultCamerasTest, KnownModelsAreSeenFromFreeSpace) {
    const std::vector<std::filesystem::path> files = availableModels();
    if (files.empty()) {
        GTEST_SKIP() << "NOT TESTED: no models; set AOLIB_MODELS_DIR";
    }
    for (const std::filesystem::path& file : files) {
        const Result<Model, LoadError> model = loadModel(file);
        ASSERT_TRUE(model.ok()) << model.error().sentence;
        const TriangleMesh mesh = model->flattened();
        const std::vector<NamedCamera> cameras = camerasFor(file.string(), *model);
        ASSERT_EQ(cameras.size(), 2U);
        for (const NamedCamera& camera : cameras) {
            SCOPED_TRACE(file.string() + ", " + camera.name);
            const float clearance = 0.005F * model->bounds().diagonal();
            EXPECT_GT(clearance, 2.0F * camera.near);
            EXPECT_EQ(test::distanceToSurface(mesh, camera.eye, clearance), clearance);
            const glm::mat4 clip = projectionMatrix(camera, 16.0F / 9.0F) * viewMatrix(camera);
            std::size_t seen = 0;
            for (const glm::vec3& p : mesh.positions) {
                const glm::vec4 c = clip * glm::vec4(p, 1.0F);
                seen += std::abs(c.x) < c.w && std::abs(c.y) < c.w && std::abs(c.z) < c.w ? 1 : 0;
            }
            EXPECT_GT(seen, mesh.positions.size() / 20) << "hardly any vertex is in the picture";
        }
    }
}

TEST(NamedCameraTest, MatricesPutTheTargetInTheMiddle) {
    const NamedCamera camera{"c", {1, 2, 3}, {4, 2, -1}, {0, 1, 0}, 60.0F, 0.5F, 50.0F};
    const glm::mat4 clip = projectionMatrix(camera, 2.0F) * viewMatrix(camera);
    const glm::vec4 middle = clip * glm::vec4(camera.target, 1.0F);
    EXPECT_NEAR(middle.x, 0.0F, 1e-5F);
    EXPECT_NEAR(middle.y, 0.0F, 1e-5F);
    EXPECT_NEAR(middle.w, 5.0F, 1e-5F);
    const glm::vec3 forward = glm::normalize(camera.target - camera.eye);
    const glm::vec4 nearest = clip * glm::vec4(camera.eye + 0.5F * forward, 1.0F);
    EXPECT_NEAR(nearest.z / nearest.w, -1.0F, 1e-4F);
    const glm::vec4 top =
        clip *
        glm::vec4(camera.eye + forward + glm::vec3(0, std::tan(glm::radians(30.0F)), 0), 1.0F);
    EXPECT_NEAR(top.y / top.w, 1.0F, 1e-4F);
}

} // namespace
} // namespace aolib
