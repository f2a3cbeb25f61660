#include "scene/Scene.h"

#include <cmath>
#include <limits>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace aolib {
namespace {

constexpr float kNotANumber = std::numeric_limits<float>::quiet_NaN();

const std::vector<glm::vec3> kPositions{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}};
const std::vector<std::uint32_t> kIndices{0, 1, 2};

Mesh triangle(const glm::mat4& transform = glm::mat4(1.0F)) {
    Result<Mesh> mesh = makeMesh({kPositions, {}, kIndices, transform});
    EXPECT_TRUE(mesh.ok());
    return *mesh;
}

StatusCode codeOf(const MeshData& data) {
    return makeMesh(data).status().code();
}

TEST(MakeMeshTest, EachFaultHasItsCode) {
    const std::vector<glm::vec3> holed{{0, 0, 0}, {kNotANumber, 0, 0}, {0, 2, 0}};
    const std::vector<std::uint32_t> two{0, 1};
    const std::vector<std::uint32_t> outside{0, 1, 3};
    const std::vector<glm::vec3> oneNormal{{0, 0, 1}};
    const std::vector<glm::vec3> badNormals{{0, 0, 1}, {0, 0, kNotANumber}, {0, 0, 1}};
    glm::mat4 badTransform(1.0F);
    badTransform[3][1] = kNotANumber;
    EXPECT_EQ(codeOf({}), StatusCode::EmptyMesh);
    EXPECT_EQ(codeOf({kPositions, {}, {}}), StatusCode::EmptyMesh);
    EXPECT_EQ(codeOf({{}, {}, kIndices}), StatusCode::EmptyMesh);
    EXPECT_EQ(codeOf({holed, {}, kIndices}), StatusCode::InvalidPosition);
    EXPECT_EQ(codeOf({kPositions, {}, two}), StatusCode::IncompletePrimitive);
    EXPECT_EQ(codeOf({kPositions, {}, outside}), StatusCode::InvalidIndex);
    EXPECT_EQ(codeOf({kPositions, oneNormal, kIndices}), StatusCode::InvalidNormal);
    EXPECT_EQ(codeOf({kPositions, badNormals, kIndices}), StatusCode::InvalidNormal);
    EXPECT_EQ(codeOf({kPositions, {}, kIndices, badTransform}), StatusCode::InvalidPosition);
    EXPECT_EQ(codeOf({kPositions, {}, kIndices, glm::scale(glm::mat4(1), glm::vec3(3e38F))}),
              StatusCode::InvalidPosition);
    EXPECT_EQ(codeOf({kPositions, {}, kIndices}), StatusCode::Ok);
}

TEST(SceneTest, BoundsFollowTheMeshes) {
    Scene scene;
    EXPECT_TRUE(scene.empty());
    EXPECT_EQ(scene.bounds().diagonal(), 0.0F);
    const MeshId a = scene.add(triangle());
    const MeshId b = scene.add(triangle(glm::translate(glm::mat4(1.0F), {10, 0, 0})));
    EXPECT_NE(a, b);
    EXPECT_EQ(scene.triangleCount(), 2U);
    EXPECT_EQ(scene.bounds().max, glm::vec3(12, 2, 0));
    ASSERT_TRUE(scene.move(b, glm::translate(glm::mat4(1.0F), {0, 5, 0})).ok());
    EXPECT_EQ(scene.bounds().max, glm::vec3(2, 7, 0));
    ASSERT_TRUE(scene.remove(b).ok());
    EXPECT_EQ(scene.bounds().max, glm::vec3(2, 2, 0));
}

TEST(SceneTest, UnknownIdsAreRefused) {
    Scene scene;
    const MeshId id = scene.add(triangle());
    ASSERT_TRUE(scene.remove(id).ok());
    EXPECT_EQ(scene.remove(id).code(), StatusCode::UnknownMesh);
    EXPECT_EQ(scene.move(id, glm::mat4(1.0F)).code(), StatusCode::UnknownMesh);
    EXPECT_EQ(scene.replace(id, triangle()).code(), StatusCode::UnknownMesh);
    EXPECT_NE(scene.add(triangle()), id) << "ids are never used again";
}

TEST(SceneTest, RefusedMoveLeavesTheMeshWhereItWas) {
    Scene scene;
    const MeshId id = scene.add(triangle());
    glm::mat4 bad(1.0F);
    bad[0][0] = kNotANumber;
    EXPECT_EQ(scene.move(id, bad).code(), StatusCode::InvalidPosition);
    EXPECT_EQ(scene.meshes().at(id).transform, glm::mat4(1.0F));
}

TEST(SceneTest, ChangesCoverBeforeAndAfter) {
    Scene scene;
    const MeshId id = scene.add(triangle());
    (void)scene.takeChanges();
    ASSERT_TRUE(scene.move(id, glm::translate(glm::mat4(1.0F), {10, 0, 0})).ok());
    const auto changes = scene.takeChanges();
    ASSERT_EQ(changes.size(), 1U);
    EXPECT_FALSE(changes[0].geometry);
    EXPECT_EQ(changes[0].region.min, glm::vec3(0, 0, 0));
    EXPECT_EQ(changes[0].region.max, glm::vec3(12, 2, 0));
    EXPECT_TRUE(scene.takeChanges().empty());
}

TEST(SceneTest, ClearanceIsTheDistanceToTheNearestTriangle) {
    Scene scene;
    EXPECT_TRUE(std::isinf(scene.clearance({}).distance));
    scene.add(triangle());
    const auto near = [&](glm::vec3 from, float distance, glm::vec3 away) {
        const Scene::Clearance found = scene.clearance(from);
        EXPECT_NEAR(found.distance, distance, 1e-6F);
        EXPECT_NEAR(glm::distance(found.away, away), 0.0F, 1e-6F);
    };
    near({0.5F, 0.5F, 3.0F}, 3.0F, {0, 0, 1});           // over the face
    near({1.0F, -2.0F, 0.0F}, 2.0F, {0, -1, 0});         // beside an edge
    near({-3.0F, -4.0F, 0.0F}, 5.0F, {-0.6F, -0.8F, 0}); // beside a corner
    near({2.0F, 2.0F, 0.0F}, std::sqrt(2.0F), glm::vec3(1, 1, 0) / std::sqrt(2.0F)); // long edge
    near({0.5F, 0.5F, 0.0F}, 0.0F, {0, 0, 1}); // on it: along the normal
}

} // namespace
} // namespace aolib
