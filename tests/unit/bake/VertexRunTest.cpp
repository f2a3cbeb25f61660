#include "bench/bake/VertexRun.h"

#include <cmath>

#include <gtest/gtest.h>

#include "BakeScenes.h"

namespace aolib::bench {

namespace {

using bake::test::sceneOf;
using bake::test::unitFloor;

TEST(VertexRunTest, ACutMeshHasTheSameSurface) {
    const bake::BakeScene floor = sceneOf(unitFloor(2));
    const CutMesh cut = cutInFour(floor);
    const bake::Surface& surface = cut.scene.surfaces[0];
    EXPECT_EQ(surface.indices.size(), 4 * floor.surfaces[0].indices.size());
    // 4 sides of 2 edges, 4 edges within, 4 diagonals.
    ASSERT_EQ(cut.ends[0].size(), 16U);
    ASSERT_EQ(surface.positions.size(), 9U + 16U);
    for (std::size_t i = 0; i < 16; ++i) {
        const auto [a, b] = cut.ends[0][i];
        const glm::vec3 middle = 0.5F * (surface.positions[a] + surface.positions[b]);
        EXPECT_EQ(surface.positions[9 + i], middle);
    }
}

TEST(VertexRunTest, ErrorsAreThoseAtVerticesAndBetweenThem) {
    const bake::BakeScene floor = sceneOf(unitFloor(1));
    const CutMesh cut = cutInFour(floor);
    std::vector<bake::BakedVertices> values(1);
    values[0].visibility = {0.5F, 0.5F, 0.5F, 0.5F};
    std::vector<bake::BakedVertices> truth(1);
    truth[0].visibility.assign(9, 0.5F);
    truth[0].visibility[0] = 0.7F;
    // Of the five middles the diagonal's stands for two thirds of each triangle's third.
    for (std::size_t i = 0; i < 5; ++i) {
        const auto [a, b] = cut.ends[0][i];
        const glm::vec3 across = floor.surfaces[0].positions[a] - floor.surfaces[0].positions[b];
        truth[0].visibility[4 + i] = std::abs(across.x * across.z) > 0.5F ? 0.8F : 0.5F;
    }
    VertexRow row;
    compareVertices(floor, cut, values, truth, row);
    EXPECT_EQ(row.vertices, 4U);
    EXPECT_NEAR(row.atVertices, 0.1, 1e-6);
    EXPECT_NEAR(row.onSurface, 0.3 / std::sqrt(3.0), 1e-6);
}

} // namespace

} // namespace aolib::bench
