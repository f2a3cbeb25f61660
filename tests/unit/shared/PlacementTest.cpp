#include "backbone/cubemapped/Placement.h"

#include <array>

#include <gtest/gtest.h>

namespace aolib {
namespace {

constexpr float kSceneSize = 100.0F;
const glm::vec3 kCamera{1, 2, 3};
const std::array<glm::vec3, 1> kElsewhere{glm::vec3(50, 2, 3)};
const std::array<glm::vec3, 1> kHere{glm::vec3(1.01F, 2, 3)};

TEST(PlacementTest, TheFirstOneIsDueAtOnce) {
    EXPECT_TRUE(Placement::due(std::nullopt, 0.75F, kCamera, {}, kSceneSize));
}

TEST(PlacementTest, WaitsForTheCount) {
    EXPECT_FALSE(Placement::due(std::nullopt, 0.75F, kCamera, kElsewhere, kSceneSize));
}

TEST(PlacementTest, FollowsTheThreshold) {
    EXPECT_TRUE(Placement::due(0.74F, 0.75F, kCamera, kElsewhere, kSceneSize));
    EXPECT_FALSE(Placement::due(0.75F, 0.75F, kCamera, kElsewhere, kSceneSize));
}

TEST(PlacementTest, AnotherInTheSamePlaceWouldSeeTheSame) {
    EXPECT_FALSE(Placement::due(0.1F, 0.75F, kCamera, kHere, kSceneSize));
}

TEST(PlacementTest, KeepsOffSurfaces) {
    // The floor y = 0 and the wall x = 0: a centre on their edge must leave both.
    const std::vector<glm::vec3> positions{{-1, 0, -1}, {1, 0, -1}, {1, 0, 1}, {-1, 0, 1},
                                           {0, -1, -1}, {0, 1, -1}, {0, 1, 1}, {0, -1, 1}};
    const std::vector<std::uint32_t> indices{0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7};
    Scene scene;
    scene.add(*makeMesh({positions, {}, indices}));
    const glm::vec3 onSurface(0.5F, 0.0F, 0.2F);
    const float needed = 0.9e-4F * scene.bounds().diagonal();
    EXPECT_GT(scene.clearance(Placement::freePosition(scene, onSurface)).distance, needed);
    const glm::vec3 onEdge(0.0F, 0.0F, 0.0F);
    EXPECT_GT(scene.clearance(Placement::freePosition(scene, onEdge)).distance, needed);
    const glm::vec3 free(0.5F, 0.5F, 0.5F);
    EXPECT_EQ(Placement::freePosition(scene, free), free);
}

} // namespace
} // namespace aolib
