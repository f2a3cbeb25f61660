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
    const Result<OpenedScene, LoadError> scene =
        openBenchScene({"plane", SceneKind::Generated, false});
    ASSERT_TRUE(scene) << scene.error().sentence;
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

/// Depths as a rasteriser would have drawn them whose pixels' centres are off by a share of a
/// pixel.
std::vector<float> depthsBeside(const OpenedScene& scene, const NamedCamera& camera,
                                const PictureSize& size, double pixels) {
    const double aspect = double(size.width) / double(size.height);
    const glm::dmat4 toClip(projectionMatrix(camera, float(aspect)) * viewMatrix(camera));
    std::vector<float> depths;
    for (int i = 0; i < size.width * size.height; ++i) {
        const Look look = lookThrough(scene.rays, camera, aspect,
                                      (double(i % size.width) + 0.5 + pixels) / double(size.width),
                                      (double(i / size.width) + 0.5) / double(size.height));
        const glm::dvec4 clip =
            look.hit ? toClip * glm::dvec4(look.hit->position, 1.0) : glm::dvec4(1.0);
        depths.push_back(static_cast<float>(clip.z / clip.w * 0.5 + 0.5));
    }
    return depths;
}

TEST(Receivers, FollowWhatWasDrawnAHairBesideTheirRay) {
    const Result<OpenedScene, LoadError> scene =
        openBenchScene({"room", SceneKind::Generated, false});
    ASSERT_TRUE(scene) << scene.error().sentence;
    const NamedCamera& camera = scene->cameras.front();
    constexpr PictureSize size{480, 270};
    const Receivers seen = findReceivers(scene->rays, camera, size, allPixels(size));
    const auto movedBy = [&](double pixels, Receivers& receivers) {
        receivers = seen;
        return followPicture(scene->rays, camera, size, depthsBeside(*scene, camera, size, pixels),
                             receivers);
    };
    Receivers followed;
    EXPECT_TRUE(followPicture(scene->rays, camera, size, {}, followed = seen).empty());
    EXPECT_TRUE(movedBy(0.0, followed).empty());
    const std::vector<std::size_t> moved = movedBy(1.0 / 64.0, followed);
    ASSERT_FALSE(moved.empty());
    EXPECT_LT(moved.size(), seen.pixels.size() / 100);
    for (const std::size_t i : moved) {
        const std::uint32_t pixel = seen.pixels[i];
        const Look look = lookThrough(scene->rays, camera, 480.0 / 270.0,
                                      (double(pixel % 480) + 0.5 + 1.0 / 64.0) / 480.0,
                                      (double(pixel / 480) + 0.5) / 270.0);
        ASSERT_TRUE(look.hit);
        EXPECT_EQ(followed.hits[i].triangle, look.hit->triangle);
        EXPECT_NEAR(glm::distance(followed.points[i].position, look.hit->position), 0.0, 1e-3);
    }
    // Where nothing has the depth that was drawn, they stay.
    const std::vector<float> near(size.pixels(), 0.01F);
    EXPECT_TRUE(followPicture(scene->rays, camera, size, near, followed = seen).empty());
}

TEST(CubeMapPositions, BeginAtTheEyeAndStayInFreeSpace) {
    const Result<OpenedScene, LoadError> scene =
        openBenchScene({"room", SceneKind::Generated, false});
    ASSERT_TRUE(scene) << scene.error().sentence;
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
