#include "content/Model.h"

#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace aolib {
namespace {

/// A triangle in the plane x + y = 1, its normal towards (1, 1, 0).
ModelMesh slanted() {
    ModelMesh mesh;
    mesh.positions = {{1, 0, 0}, {0, 1, 0}, {1, 0, 1}};
    mesh.indices = {0, 1, 2};
    mesh.normals.assign(3, glm::normalize(glm::vec3(1, 1, 0)));
    return mesh;
}

glm::vec3 faceNormal(const TriangleMesh& mesh, std::size_t triangle) {
    const glm::vec3& a = mesh.positions[mesh.indices[3 * triangle]];
    const glm::vec3& b = mesh.positions[mesh.indices[3 * triangle + 1]];
    const glm::vec3& c = mesh.positions[mesh.indices[3 * triangle + 2]];
    return glm::normalize(glm::cross(b - a, c - a));
}

TEST(ModelTest, NormalsGoThroughTheInverseTranspose) {
    Model model{"m", {slanted()}};
    model.meshes[0].transform = glm::scale(glm::mat4(1.0F), {4.0F, 1.0F, 1.0F});
    const TriangleMesh flat = model.flattened();
    const glm::vec3 expected = glm::normalize(glm::vec3(0.25F, 1.0F, 0.0F));
    EXPECT_LT(glm::distance(flat.normals[0], expected), 1e-6F);
    EXPECT_LT(glm::distance(faceNormal(flat, 0), expected), 1e-6F);
}

TEST(ModelTest, MirroringFlipsTheWindingAndKeepsNormalsOnTheirSide) {
    Model model{"m", {slanted()}};
    model.meshes[0].transform = glm::scale(glm::mat4(1.0F), {-1.0F, 1.0F, 1.0F});
    const TriangleMesh flat = model.flattened();
    const glm::vec3 expected = glm::normalize(glm::vec3(-1.0F, 1.0F, 0.0F));
    EXPECT_LT(glm::distance(flat.normals[0], expected), 1e-6F);
    EXPECT_LT(glm::distance(faceNormal(flat, 0), expected), 1e-6F);
}

TEST(ModelTest, NormalsSurviveScalesOfZero) {
    Model model{"m", {slanted()}};
    model.meshes[0].transform = glm::scale(glm::mat4(1.0F), {1.0F, 0.0F, 1.0F});
    EXPECT_LT(glm::distance(model.flattened().normals[0], glm::vec3(0, 1, 0)), 1e-6F);
}

TEST(ModelTest, ZeroNormalsStayZero) {
    Model model{"m", {slanted()}};
    model.meshes[0].normals[1] = glm::vec3(0.0F);
    model.meshes[0].transform = glm::scale(glm::mat4(1.0F), {3.0F, 1.0F, 1.0F});
    EXPECT_EQ(model.flattened().normals[1], glm::vec3(0.0F));
    EXPECT_NEAR(glm::length(model.flattened().normals[0]), 1.0F, 1e-6F);
}

TEST(ModelTest, MeshesWithoutNormalsGetThoseOfTheirFaces) {
    Model model{"m", {slanted(), slanted()}};
    model.meshes[1].normals.clear();
    model.meshes[1].indices = {0, 1, 2, 2, 1, 0};
    const TriangleMesh flat = model.flattened();
    ASSERT_EQ(flat.normals.size(), flat.positions.size());
    for (std::size_t i = 0; i < flat.triangleCount(); ++i) {
        EXPECT_GT(glm::dot(flat.normals[flat.indices[3 * i]], faceNormal(flat, i)), 0.999F);
    }
    model.meshes.erase(model.meshes.begin());
    EXPECT_TRUE(model.flattened().normals.empty());
}

TEST(ModelTest, BoundsHoldWhatTrianglesUse) {
    Model model{"m", {slanted()}};
    model.meshes[0].positions.emplace_back(1000.0F);
    model.meshes[0].transform = glm::translate(glm::mat4(1.0F), {0, 5, 0});
    EXPECT_EQ(model.bounds().min, glm::vec3(0, 5, 0));
    EXPECT_EQ(model.bounds().max, glm::vec3(1, 6, 1));
    EXPECT_EQ(model.triangleCount(), 1U);
    EXPECT_TRUE(Model().bounds().empty());
}

} // namespace
} // namespace aolib
