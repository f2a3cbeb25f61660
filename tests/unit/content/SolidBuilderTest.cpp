#include "content/generated/SolidBuilder.h"

#include <cmath>

#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <gtest/gtest.h>

#include "Watertight.h"

namespace aolib {
namespace {

const Frame upright{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};

/// Closed, of the expected volume, and with normals on the side of the faces.
void expectSolid(SolidBuilder& builder, double volume) {
    const ModelMesh mesh = builder.finish("solid", glm::vec3(1.0F));
    EXPECT_EQ(test::unbalancedEdges(mesh), 0U);
    EXPECT_NEAR(test::signedVolume(mesh), volume, 1e-4 * volume);
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const glm::vec3& a = mesh.positions[mesh.indices[i]];
        const glm::vec3 face = glm::cross(mesh.positions[mesh.indices[i + 1]] - a,
                                          mesh.positions[mesh.indices[i + 2]] - a);
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::vec3& normal = mesh.normals[mesh.indices[i + k]];
            EXPECT_NEAR(glm::length(normal), 1.0F, 1e-4F);
            EXPECT_GT(glm::dot(normal, face), 0.0F);
        }
    }
}

TEST(SolidBuilderTest, Box) {
    SolidBuilder builder;
    builder.setPlace(glm::rotate(glm::translate(glm::mat4(1.0F), {30, 1, -40}), 0.7F, {0, 1, 0}));
    builder.box({1, 2, 3}, {2, 4, 6});
    EXPECT_EQ(builder.triangleCount(), 12U);
    expectSolid(builder, 6.0);
}

TEST(SolidBuilderTest, FrustumsRoofsAndPyramids) {
    SolidBuilder builder;
    builder.frustum({2, 1}, {0, 0}, 0, 3);
    EXPECT_EQ(builder.triangleCount(), 6U);
    expectSolid(builder, 8.0);
    builder.frustum({2, 1}, {1, 0}, 0, 3); // a hip roof: a prism and two half pyramids
    expectSolid(builder, 6.0 + 4.0);
    builder.frustum({2, 2}, {1, 1}, 0, 3);
    expectSolid(builder, 28.0);
}

TEST(SolidBuilderTest, SlabWithRecessesAndHoles) {
    SolidBuilder builder;
    builder.slab(upright, rectangle({0, 0}, {10, 4}), 1.0F,
                 {{rectangle({1, 1}, {2, 2}), 0.5F},
                  {rectangle({3, 1}, {4, 2}), 0.0F, true},
                  {rectangle({5, 1}, {6, 2}), 0.25F}});
    expectSolid(builder, 40.0 - 0.5 - 1.0 - 0.25);
}

TEST(SolidBuilderTest, LathesOnAndOffTheAxis) {
    SolidBuilder builder;
    constexpr int segments = 48;
    const double polygon =
        0.5 * segments * std::sin(glm::two_pi<double>() / segments); // area for radius 1
    builder.lathe({{0, 0}, {2, 0}, {2, 3}, {0, 3}}, segments);
    expectSolid(builder, polygon * 4.0 * 3.0);
    builder.lathe({{1, 0}, {2, 0}, {2, 3}, {1, 3}}, segments, true);
    expectSolid(builder, polygon * (4.0 - 1.0) * 3.0);
}

TEST(SolidBuilderTest, SweepsOpenAndClosed) {
    SolidBuilder builder;
    const Outline profile = rectangle({-0.5F, 0}, {0.5F, 2});
    builder.sweep(profile, {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 0, 5}, {1, 0, 0}, {0, 1, 0}}},
                  false);
    expectSolid(builder, 10.0);
    builder.sweep(profile, {{{0, 0, 5}, {1, 0, 0}, {0, 1, 0}}, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}},
                  false); // the other way along
    expectSolid(builder, 10.0);
}

TEST(SolidBuilderTest, WeldsWhatIsNearlyEqual) {
    SolidBuilder builder;
    builder.triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    builder.triangle({1, 0, 0.00002F}, {1, 1, 0}, {0, 1, 0.00002F});
    const ModelMesh mesh = builder.finish("two", glm::vec3(1.0F));
    EXPECT_EQ(mesh.positions[3], mesh.positions[1]);
    EXPECT_EQ(mesh.positions[5], mesh.positions[2]);
}

} // namespace
} // namespace aolib
