#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <aolib/lighting/ConeTable.h>

#include "TestSkies.h"
#include "content/generated/Environments.h"
#include "reference/EnvironmentTracer.h"
#include "reference/OpeningTracer.h"

namespace aolib {
namespace {

using lighting::EnvironmentMap;
using lighting::test::evenSky;

/// A floor, and a wall of endless reach beside it if wanted: x below 0 is hidden.
RayScene floorAndWall(bool wall) {
    TriangleMesh mesh;
    mesh.positions = {{-9, 0, -9}, {-9, 0, 9}, {9, 0, 9}, {9, 0, -9}};
    mesh.indices = {0, 1, 2, 0, 2, 3};
    if (wall) {
        mesh.positions.insert(mesh.positions.end(),
                              {{0, 0, -1e4F}, {0, 1e4F, -1e4F}, {0, 1e4F, 1e4F}, {0, 0, 1e4F}});
        mesh.indices.insert(mesh.indices.end(), {4, 5, 6, 4, 6, 7});
    }
    return std::move(*RayScene::create(std::move(mesh)));
}

const std::vector<Receiver> onTheFloor{{{0.5, 0.0, 0.0}, {0.0, 1.0, 0.0}, -1.0}};

LightList traced(const RayScene& scene, const EnvironmentMap& map, int rays = 1024) {
    LightSettings settings;
    settings.rays = rays;
    Result<LightList> list = traceEnvironment(scene, map, onTheFloor, settings);
    EXPECT_TRUE(list.ok()) << list.status().message();
    EXPECT_TRUE(list->complete);
    return *list;
}

TEST(EnvironmentTracerTest, AWhiteFloorInAnEvenSkyIsAsBrightAsTheSky) {
    EXPECT_NEAR(traced(floorAndWall(false), evenSky(2.5F)).radiance[0].r, 2.5F, 0.03F);
}

TEST(EnvironmentTracerTest, AWallTakesHalfOfIt) {
    EXPECT_NEAR(traced(floorAndWall(true), evenSky(2.0F)).radiance[0].g, 1.0F, 0.02F);
}

TEST(EnvironmentTracerTest, OpenSurfacesAgreeWithTheConeTable) {
    const RayScene scene = floorAndWall(false);
    for (const char* name : {"sunny", "window"}) {
        const EnvironmentMap map = findGeneratedEnvironment(name)->build();
        const auto cones =
            lighting::ConeTable::create(map, {.columns = 8, .rows = 3, .apertures = 2});
        const glm::vec3 open = cones->lookup({0, 1, 0}, 1.0F);
        const LightList list = traced(scene, map, 4096);
        EXPECT_NEAR(glm::distance(list.radiance[0], open), 0.0F, 0.01F * glm::length(open)) << name;
    }
}

TEST(EnvironmentTracerTest, ASunBehindAWallIsHidden) {
    // The sun of "sunny" stands at x > 0; turned by half a turn it is behind the wall.
    const EnvironmentMap map = findGeneratedEnvironment("sunny")->build();
    const float before = traced(floorAndWall(true), map).radiance[0].r;
    const float behind = traced(floorAndWall(true), lighting::turned(map, 0.5F)).radiance[0].r;
    // Irradiance 4 at 40 degrees, over pi.
    EXPECT_NEAR(before - behind, 4.0F * std::sin(0.698F) / 3.1416F, 0.1F);
}

TEST(EnvironmentTracerTest, TheNoiseThatIsSaidIsTheNoiseThereIs) {
    const RayScene scene = floorAndWall(true);
    const EnvironmentMap map = findGeneratedEnvironment("window")->build();
    const std::vector<Receiver> many(400, onTheFloor[0]);
    LightSettings settings;
    settings.rays = 64;
    const auto list = traceEnvironment(scene, map, many, settings);
    const glm::vec3 exact = traced(scene, map, 1 << 18).radiance[0];
    double squares = 0.0;
    for (const glm::vec3& value : list->radiance) {
        squares += double(glm::dot(value - exact, value - exact)) / 3.0;
    }
    const double actual = std::sqrt(squares / double(many.size()));
    EXPECT_GT(actual, 0.0);
    EXPECT_NEAR(list->noise / actual, 1.0, 0.15);
}

TEST(EnvironmentTracerTest, SamplesHaveTheDensityThatTheySay) {
    const EnvironmentMap map = findGeneratedEnvironment("studio")->build();
    const EnvironmentSampler sampler(map);
    // The mean of 1 / density over samples is the solid angle of what has any brightness.
    double sum = 0.0;
    constexpr int side = 256;
    for (int i = 0; i < side * side; ++i) {
        const auto sample = sampler.sample({(i % side + 0.5) / side, (i / side + 0.5) / side});
        EXPECT_NEAR(glm::length(sample.direction), 1.0, 1e-9);
        const auto again = sampler.at(sample.direction);
        EXPECT_DOUBLE_EQ(again.density, sample.density) << i;
        sum += 1.0 / sample.density;
    }
    EXPECT_NEAR(sum / (side * side) / (4.0 * 3.14159265), 1.0, 0.03);
}

TEST(EnvironmentTracerTest, DarknessIsDark) {
    EXPECT_EQ(traced(floorAndWall(false), evenSky(0.0F)).radiance[0], glm::vec3(0.0F));
}

TEST(EnvironmentTracerTest, MistakesAreNamed) {
    const RayScene scene = floorAndWall(false);
    const EnvironmentMap sky = evenSky(1.0F);
    LightSettings settings;
    settings.rays = 7;
    EXPECT_EQ(traceEnvironment(scene, sky, onTheFloor, settings).status().code(),
              StatusCode::InvalidOption);
    settings.rays = 8;
    const std::vector<Receiver> noNormal{{{0, 0, 0}, {0, 0, 0}, -1.0}};
    EXPECT_EQ(traceEnvironment(scene, sky, noNormal, settings).status().code(),
              StatusCode::InvalidNormal);
    const std::vector<Receiver> nowhere{
        {{std::numeric_limits<double>::quiet_NaN(), 0, 0}, {0, 1, 0}, -1.0}};
    EXPECT_EQ(traceEnvironment(scene, sky, nowhere, settings).status().code(),
              StatusCode::InvalidPosition);
}

TEST(OpeningTracerTest, HalfAHemisphereBesideAWall) {
    const auto openings = traceOpenings(floorAndWall(true), onTheFloor, 4096, 0);
    EXPECT_NEAR(openings[0].visibility, 0.5F, 0.01F);
    EXPECT_NEAR(openings[0].share, 0.5F, 0.01F);
    // By the cosine (4 / 3 pi, 2 / 3); plain (1/2, 1/2) of a quarter of a sphere.
    const glm::vec3 bent = glm::normalize(glm::vec3(4.0F / (3.0F * 3.14159F), 2.0F / 3.0F, 0.0F));
    EXPECT_GT(glm::dot(openings[0].bentNormal, bent), 0.9998F);
    EXPECT_GT(glm::dot(openings[0].meanDirection, glm::normalize(glm::vec3(1, 1, 0))), 0.9998F);
}

} // namespace
} // namespace aolib
