#include <vector>

#include <gtest/gtest.h>

#include "BakeScenes.h"
#include "bench/bake/MapErrors.h"

namespace aolib::bake::test {

namespace {

/// Bakes by rays that are watched, and ended where the watch says so.
std::unique_ptr<AbstractBaker> bakerOf(BakeScene scene, int rays) {
    RayOptions options;
    options.rays = rays;
    auto baker = createRayBaker(std::move(scene), options);
    EXPECT_TRUE(baker.ok());
    return std::move(*baker);
}

MapOptions smallMap(int texelSamples) {
    MapOptions options;
    options.width = options.height = 24;
    options.texelSamples = texelSamples;
    return options;
}

/// Ends a bake as soon as there are so many samples.
SnapshotCallback until(int samples) {
    return [samples](BakeSnapshot& snapshot) { return snapshot.samples() < samples; };
}

TEST(WatchTest, ABakeThatIsEndedIsOneOfSoManyRays) {
    const MapOptions options = smallMap(1);
    const auto whole = bakerOf(floorBesideWall(0.5), 256)->bakeMaps(options, {}, until(128));
    const auto half = bakerOf(floorBesideWall(0.5), 128)->bakeMaps(options, {});
    ASSERT_TRUE(whole.ok() && half.ok());
    EXPECT_EQ(whole->front().visibility, half->front().visibility);
    EXPECT_EQ(whole->front().bentNormal, half->front().bentNormal);
}

TEST(WatchTest, MoreRaysAreNearerToTheTruth) {
    const BakedMap truth = std::move(
        bakerOf(sceneOf(uvShape("uv-shapes")), 2048)->bakeMaps(smallMap(16), {})->front());
    std::vector<int> samples;
    std::vector<double> errors;
    std::vector<float> last;
    const auto watch = [&](BakeSnapshot& snapshot) {
        EXPECT_EQ(snapshot.wantedSamples(), 256);
        samples.push_back(snapshot.samples());
        const auto maps = snapshot.maps();
        EXPECT_TRUE(maps.ok());
        errors.push_back(bench::errorsOf(maps->front(), truth).inside);
        last = maps->front().visibility;
        return true;
    };
    const auto maps =
        bakerOf(sceneOf(uvShape("uv-shapes")), 256)->bakeMaps(smallMap(16), {}, watch);
    ASSERT_TRUE(maps.ok());
    ASSERT_EQ(samples.size(), 16U);
    EXPECT_EQ(samples[3], 64);
    // Sobol's points: faster than the root of their number, 1.4 a doubling.
    EXPECT_LT(errors[3], errors[0] / 1.8);
    EXPECT_LT(errors[15], errors[3] / 1.8);
    // Its rays start at four places in each texel so far, those of a bake of 64 at sixteen.
    const auto quarter = bakerOf(sceneOf(uvShape("uv-shapes")), 64)->bakeMaps(smallMap(16), {});
    EXPECT_LT(errors[3], 1.5 * bench::errorsOf(quarter->front(), truth).inside);
    EXPECT_EQ(maps->front().visibility, last) << "who watches sees what there will be";
}

TEST(WatchTest, AllMapsHaveValuesBeforeTheFirstIsDone) {
    BakeScene scene = openBesideClosedChart();
    scene.surfaces[1].map = 1;
    std::vector<int> seen;
    const auto watch = [&](BakeSnapshot& snapshot) {
        seen.push_back(snapshot.samples());
        return seen.size() < 2;
    };
    const auto maps = bakerOf(std::move(scene), 64)->bakeMaps(smallMap(4), {}, watch);
    ASSERT_TRUE(maps.ok());
    EXPECT_EQ(seen, (std::vector<int>{16, 16})) << "the first map has had its second pass then";
    EXPECT_GT((*maps)[0].visibility[24 * 12 + 4], 0.9F);
    EXPECT_LT((*maps)[1].visibility[24 * 12 + 14], 0.1F);
    EXPECT_GE((*maps)[1].visibility[24 * 12 + 14], 0.0F);
}

TEST(WatchTest, WhatIsCancelledGivesNothingHoweverMuchThereIs) {
    bool watched = false;
    const auto maps = bakerOf(floorBesideWall(0.5), 256)
                          ->bakeMaps(
                              smallMap(16), [](double done) { return done < 0.5; },
                              [&](BakeSnapshot&) { return watched = true; });
    EXPECT_EQ(maps.status().code(), StatusCode::Cancelled);
    EXPECT_TRUE(watched);
}

TEST(WatchTest, ManyRaysComeInManyPasses) {
    int calls = 0;
    const auto count = [&](BakeSnapshot&) { return ++calls > 0; };
    ASSERT_TRUE(bakerOf(floorBesideWall(0.5), 512)->bakeMaps(smallMap(2), {}, count).ok());
    EXPECT_EQ(calls, 8) << "of 64 each, from two places in turn";
}

} // namespace

} // namespace aolib::bake::test
