#include "bench/Receivers.h"

#include <cmath>
#include <set>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "bench/CubeMapPositions.h"
#include "bench/OpenedScene.h"

namespace aolib::bench {
namespace {

constexpr PictureSize kSize{32, 18};

TEST(Lattice, HasOnePixelInEveryCell) {
    const std::vector<std::uint32_t> pixels = latticePixels({10, 7}, 3, 5);
    std::set<std::uint32_t> cells;
    for (const std::uint32_t pixel : pixels) {
        const std::uint32_t x = pixel % 10;
        const std::uint32_t y = pixel / 10;
        ASSERT_LT(y, 7U);
        EXPECT_TRUE(cells.insert((y / 3) * 4 + x / 3).second);
    }
    EXPECT_EQ(cells.size(), 4U * 3U);
}

TEST(Lattice, FollowsItsSeed) {
    EXPECT_EQ(latticePixels(kSize, 3, 1), latticePixels(kSize, 3, 1));
    EXPECT_NE(latticePixels(kSize, 3, 1), latticePixels(kSize, 3, 2));
}

TEST(Receivers, LieOnTheSurfaceAndFaceTheEyeOnEitherSide) {
    const Loaded<OpenedScene> scene = openBenchScene({"plane", SceneKind::Generated, false});
    ASSERT_TRUE(scene) << scene.sentence();
    const float height = scene->model.bounds().max.y;
    for (const float side : {1.0F, -1.0F}) {
        NamedCamera camera = scene->cameras.front();
        camera.eye.y = height + side * std::abs(camera.eye.y - height);
        const Receivers seen = findReceivers(scene->rays, camera, kSize, allPixels(kSize));
        ASSERT_FALSE(seen.points.empty());
        for (const Receiver& point : seen.points) {
            EXPECT_NEAR(point.position.y, double{height}, 1e-4);
            EXPECT_GT(side * point.normal.y, 0.99);
            EXPECT_GE(side * (point.position.y - double{height}), 0.0) << "not lifted";
        }
    }
}

TEST(CubeMapPositions, BeginAtTheEyeAndStayInFreeSpace) {
    const Loaded<OpenedScene> scene = openBenchScene({"room", SceneKind::Generated, false});
    ASSERT_TRUE(scene) << scene.sentence();
    const NamedCamera& camera = scene->cameras.front();
    const std::vector<glm::vec3> positions = cubeMapPositions(*scene, camera, kSize, 20);
    ASSERT_EQ(positions.size(), 20U);
    EXPECT_EQ(positions[0], camera.eye);
    std::set<float> distances;
    for (std::size_t i = 1; i < positions.size(); ++i) {
        const glm::dvec3 eye(camera.eye);
        const glm::dvec3 to = glm::dvec3(positions[i]) - eye;
        EXPECT_FALSE(scene->rays.occluded(eye, to, 0.0, 1.5 * glm::length(to))) << i;
        distances.insert(positions[i].x);
    }
    EXPECT_EQ(distances.size(), 19U) << "two cube maps at one place";
}

} // namespace
} // namespace aolib::bench
