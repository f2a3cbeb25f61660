#include "scene/WorldTriangles.h"

#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace aolib {
namespace {

/// A triangle in the plane whose normal is `facing`, with that normal, in length, at all corners.
Mesh triangle(const glm::vec3& facing, const glm::mat4& transform, float length = 1.0F) {
    const glm::vec3 side =
        glm::normalize(glm::cross(facing, std::abs(facing.x) < 0.8F ? glm::vec3(1.0F, 0.0F, 0.0F)
                                                                    : glm::vec3(0.0F, 1.0F, 0.0F)));
    Mesh mesh;
    mesh.positions = {glm::vec3(0.0F), side, glm::cross(facing, side)};
    mesh.normals.assign(3, length * facing);
    mesh.indices = {0, 1, 2};
    mesh.transform = transform;
    for (const glm::vec3& p : mesh.positions) {
        mesh.modelBounds.include(p);
    }
    return mesh;
}

TriangleMesh worldOf(std::initializer_list<Mesh> meshes) {
    Scene scene;
    for (const Mesh& mesh : meshes) {
        scene.add(mesh);
    }
    return worldTriangles(scene);
}

glm::dvec3 geometricNormal(const TriangleMesh& mesh) {
    const glm::dvec3 a(mesh.positions[0]);
    return glm::normalize(
        glm::cross(glm::dvec3(mesh.positions[1]) - a, glm::dvec3(mesh.positions[2]) - a));
}

const glm::vec3 slanted = glm::normalize(glm::vec3(2.0F, -3.0F, 1.0F));

TEST(WorldTriangles, NormalsStayAcrossTheirTriangles) {
    const glm::mat4 turned = glm::rotate(glm::mat4(1.0F), 1.1F, glm::vec3(0.3F, 0.5F, -0.8F));
    const glm::mat4 uneven = glm::scale(turned, glm::vec3(3.0F, 0.5F, 7.0F));
    glm::mat4 sheared = uneven;
    sheared[1] += 2.0F * sheared[0];
    for (const float size : {1.0F, 1e-12F, 1e12F}) {
        for (const glm::mat4& shape : {glm::mat4(1.0F), turned, uneven, sheared}) {
            for (const float length : {1.0F, 1e-18F, 1e18F}) {
                const glm::mat4 transform = glm::scale(shape, glm::vec3(size));
                const TriangleMesh world = worldOf({triangle(slanted, transform, length)});
                ASSERT_EQ(world.normals.size(), 3U);
                for (const glm::vec3& normal : world.normals) {
                    EXPECT_NEAR(glm::distance(glm::dvec3(normal), geometricNormal(world)), 0.0,
                                1e-5);
                }
            }
        }
    }
}

/// A mirror turns the winding round; normals still point away from what they pointed away from.
TEST(WorldTriangles, MirrorsKeepNormalsOnTheirSide) {
    const glm::mat4 mirror = glm::scale(glm::mat4(1.0F), glm::vec3(-2.0F, 1.0F, 1.0F));
    const TriangleMesh world = worldOf({triangle(slanted, mirror)});
    EXPECT_NEAR(glm::distance(glm::dvec3(world.normals[0]), -geometricNormal(world)), 0.0, 1e-6);
    EXPECT_LT(world.normals[0].x, 0.0F) << "as the mirror has it";
}

TEST(WorldTriangles, WhatIsSquashedToAPlaneFacesAcrossIt) {
    const glm::mat4 squashed = glm::scale(glm::mat4(1.0F), glm::vec3(2.0F, 0.0F, 3.0F));
    const TriangleMesh world = worldOf({triangle(slanted, squashed)});
    EXPECT_NEAR(std::abs(world.normals[0].y), 1.0F, 1e-6F);
    const glm::mat4 line = glm::scale(glm::mat4(1.0F), glm::vec3(2.0F, 0.0F, 0.0F));
    EXPECT_EQ(worldOf({triangle(slanted, line)}).normals[0], glm::vec3(0.0F));
    EXPECT_EQ(worldOf({triangle(slanted, glm::mat4(0.0F))}).normals[0], glm::vec3(0.0F));
}

TEST(WorldTriangles, MeshesAndVerticesMayLackNormals) {
    Mesh without = triangle(slanted, glm::mat4(1.0F));
    without.normals.clear();
    EXPECT_TRUE(worldOf({without, without}).normals.empty());
    Mesh partly = triangle(slanted, glm::mat4(1.0F));
    partly.normals[1] = glm::vec3(0.0F);
    const TriangleMesh world = worldOf({without, partly, without});
    ASSERT_EQ(world.positions.size(), 9U);
    ASSERT_EQ(world.normals.size(), 9U);
    for (const std::size_t vertex : {0U, 1U, 2U, 4U, 6U, 7U, 8U}) {
        EXPECT_EQ(world.normals[vertex], glm::vec3(0.0F)) << vertex;
    }
    for (const std::size_t vertex : {3U, 5U}) {
        EXPECT_NEAR(glm::distance(world.normals[vertex], slanted), 0.0F, 1e-6F) << vertex;
    }
    EXPECT_EQ(world.indices, (std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5, 6, 7, 8}));
}

} // namespace
} // namespace aolib
