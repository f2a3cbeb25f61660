#include "backbone/cubemaps/Placement.h"

#include <array>

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

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

/// A frame of an orthographic camera above the origin that looks down on so much.
Frame fromAbove(float height, float half, float near, float far) {
    const glm::vec3 eye(0, height, 0);
    const glm::mat4 view = glm::lookAt(eye, eye - glm::vec3(0, 1, 0), glm::vec3(0, 0, -1));
    const glm::mat4 projection = glm::ortho(-half, half, -half, half, near, far);
    return {.camera = *HostCamera::create(view, projection),
            .position = eye,
            .size = {100, 100},
            .clip = {}};
}

TEST(PlacementTest, AnOrthographicEyeStandsBeforeWhatItSees) {
    const Bounds scene{glm::vec3(-8, 0, -8), glm::vec3(8, 3, 8)};
    const glm::vec3 wide = Placement::standpoint(fromAbove(30, 10, 0.1F, 100), scene, 16);
    EXPECT_NEAR(wide.x, 0, 1e-4F);
    EXPECT_NEAR(wide.y, 3 + 8, 1e-3F) << "a right angle over what there is";
    for (const float height : {-20.0F, 0.0F, 5.0F, 1000.0F}) { // it means nothing
        const glm::vec3 at = Placement::standpoint(fromAbove(height, 10, -2000, 2000), scene, 16);
        EXPECT_NEAR(glm::distance(at, wide), 0, 1e-2F) << height;
    }
    const glm::vec3 close = Placement::standpoint(fromAbove(30, 1, 0.1F, 100), scene, 16);
    EXPECT_NEAR(close.y, 3 + 1, 1e-3F) << "over what the view shows";
    const glm::vec3 fine = Placement::standpoint(fromAbove(30, 10, 0.1F, 100), scene, 512);
    EXPECT_NEAR(fine.y, 3 + 512 * 0.2F, 0.1F) << "texels two pixels wide";
    const glm::vec3 cut = Placement::standpoint(fromAbove(30, 10, 28.5F, 100), scene, 16);
    EXPECT_NEAR(cut.y, 1.5F, 1e-3F) << "on the plane that cuts the scene";
    const glm::vec3 across =
        Placement::across(fromAbove(30, 10, 0.1F, 100).camera, wide, {5, 1, -2});
    EXPECT_NEAR(glm::distance(across, glm::vec3(5, 11, -2)), 0, 1e-3F);
}

TEST(PlacementTest, APerspectiveEyeStandsWhereItIs) {
    Frame frame = fromAbove(30, 10, 0.1F, 100);
    frame.camera = *HostCamera::create(glm::mat4(1), glm::perspective(1.0F, 1.0F, 0.1F, 9.0F));
    frame.position = {1, 2, 3};
    EXPECT_EQ(Placement::standpoint(frame, {glm::vec3(-1), glm::vec3(1)}, 512), frame.position);
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
