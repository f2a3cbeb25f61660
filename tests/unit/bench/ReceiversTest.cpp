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

TEST(Receivers, LieOnTheSurfaceAndFaceTheEye) {
    const Loaded<OpenedScene> scene = openBenchScene({"plane", SceneKind::Generated, false});
    ASSERT_TRUE(scene) << scene.sentence();
    const NamedCamera& camera = scene->cameras.front();
    const Receivers seen = findReceivers(scene->rays, camera, kSize, allPixels(kSize));
    ASSERT_FALSE(seen.points.empty());
    const Bounds bounds = scene->model.bounds();
    for (const Receiver& point : seen.points) {
        EXPECT_NEAR(point.position.y, double(bounds.max.y), 1e-4);
        EXPECT_GT(glm::dot(point.normal, glm::dvec3(camera.eye) - point.position), 0.0);
        EXPECT_NEAR(glm::length(point.normal), 1.0, 1e-9);
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
