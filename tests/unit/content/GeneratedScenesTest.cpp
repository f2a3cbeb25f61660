#include "content/generated/GeneratedScenes.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "Proximity.h"

namespace aolib {
namespace {

class GeneratedScenesTest : public testing::TestWithParam<GeneratedScene> {};

INSTANTIATE_TEST_SUITE_P(Every, GeneratedScenesTest, testing::ValuesIn(generatedScenes()),
                         [](const auto& scene) {
                             std::string name = scene.param.name;
                             name.erase(std::remove(name.begin(), name.end(), '-'), name.end());
                             return name;
                         });

TEST_P(GeneratedScenesTest, IsSound) {
    const Model model = GetParam().build();
    EXPECT_EQ(model.name, GetParam().name);
    std::size_t slivers = 0;
    for (const ModelMesh& mesh : model.meshes) {
        SCOPED_TRACE(mesh.name);
        EXPECT_FALSE(mesh.name.empty());
        ASSERT_FALSE(mesh.indices.empty());
        ASSERT_EQ(mesh.indices.size() % 3, 0U);
        ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
        for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
            const glm::vec3& p = mesh.positions[i];
            ASSERT_TRUE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
            ASSERT_NEAR(glm::length(mesh.normals[i]), 1.0F, 1e-3F);
        }
        std::size_t contrary = 0;
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
            for (std::size_t k = 0; k < 3; ++k) {
                ASSERT_LT(mesh.indices[i + k], mesh.positions.size());
            }
            const glm::vec3& a = mesh.positions[mesh.indices[i]];
            const glm::vec3 face = glm::cross(mesh.positions[mesh.indices[i + 1]] - a,
                                              mesh.positions[mesh.indices[i + 2]] - a);
            slivers += glm::length(face) <= 1e-8F ? 1 : 0;
            contrary += glm::dot(face, mesh.normals[mesh.indices[i]]) < 0.0F ? 1 : 0;
        }
        EXPECT_LE(contrary, mesh.triangleCount() / 1000);
    }
    EXPECT_LE(slivers, model.triangleCount() / 1000);
}

TEST_P(GeneratedScenesTest, IsTheSameEveryTime) {
    const Model first = GetParam().build();
    const Model second = GetParam().build();
    ASSERT_EQ(first.meshes.size(), second.meshes.size());
    for (std::size_t i = 0; i < first.meshes.size(); ++i) {
        EXPECT_EQ(first.meshes[i].positions, second.meshes[i].positions);
        EXPECT_EQ(first.meshes[i].indices, second.meshes[i].indices);
        EXPECT_EQ(first.meshes[i].baseColour, second.meshes[i].baseColour);
    }
}

TEST_P(GeneratedScenesTest, CamerasStandInFreeSpaceAndSeeSomething) {
    const TriangleMesh mesh = GetParam().build().flattened();
    const std::vector<NamedCamera> cameras = GetParam().cameras();
    EXPECT_GE(cameras.size(), 2U);
    std::set<std::string> names;
    for (const NamedCamera& camera : cameras) {
        SCOPED_TRACE(camera.name);
        EXPECT_TRUE(names.insert(camera.name).second);
        EXPECT_EQ(test::distanceToSurface(mesh, camera.eye, 2.0F * camera.near),
                  2.0F * camera.near);
        const glm::vec3 forward = glm::normalize(camera.target - camera.eye);
        const std::optional<float> hit = test::firstHit(mesh, camera.eye, forward);
        ASSERT_TRUE(hit.has_value());
        EXPECT_GT(*hit, camera.near);
        EXPECT_LT(*hit, camera.far);
    }
}

std::size_t trianglesOf(const char* name) {
    return findGeneratedScene(name)->build().triangleCount();
}

TEST(GeneratedScenes, KeepTheirBudgets) {
    EXPECT_NEAR(static_cast<double>(trianglesOf("town")), 12000.0, 1200.0);
    EXPECT_NEAR(static_cast<double>(trianglesOf("dome")), 564000.0, 0.03 * 564000.0);
    EXPECT_LT(trianglesOf("room"), 20000U);
    EXPECT_EQ(trianglesOf("cornell"), 34U);
    EXPECT_EQ(trianglesOf("plane"), 2U);
    EXPECT_EQ(trianglesOf("wall"), 4U);
}

TEST(GeneratedScenes, AreFoundByName) {
    EXPECT_EQ(findGeneratedScene("nowhere"), nullptr);
    for (const GeneratedScene& scene : generatedScenes()) {
        EXPECT_EQ(findGeneratedScene(scene.name)->build, scene.build);
    }
}

TEST(GeneratedScenes, InteriorsAreClosed) {
    for (const char* name : {"room", "sphere-inside"}) {
        const GeneratedScene* scene = findGeneratedScene(name);
        const TriangleMesh mesh = scene->build().flattened();
        const glm::vec3 eye = scene->cameras()[0].eye;
        for (int i = 0; i < 400; ++i) { // directions spread over the sphere in a spiral
            const float y = 1.0F - 2.0F * (static_cast<float>(i) + 0.5F) / 400.0F;
            const float angle = 2.39996F * static_cast<float>(i);
            const float r = std::sqrt(1.0F - y * y);
            const glm::vec3 direction{r * std::cos(angle), y, r * std::sin(angle)};
            EXPECT_TRUE(test::firstHit(mesh, eye, direction).has_value()) << name << ", ray " << i;
        }
    }
}

} // namespace
} // namespace aolib
