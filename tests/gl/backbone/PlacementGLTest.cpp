// Cube maps by coverage: the first at the eye, the next where a walk turns a corner.
#include <chrono>
#include <thread>

#include <aolib/RayTracing.h>

#include "SmallScene.h"

namespace aolib {
namespace {

/// A corridor along x that turns and goes on along z.
Model corridor() {
    Model model;
    addQuad(model, {-2, 0, -2}, {-2, 0, 22}, {22, 0, 22}, {22, 0, -2});
    addQuad(model, {-2, 0, -2}, {22, 0, -2}, {22, 4, -2}, {-2, 4, -2});
    addQuad(model, {22, 0, -2}, {22, 0, 22}, {22, 4, 22}, {22, 4, -2});
    addBox(model, {-2, 0, 2}, {18, 4, 22});
    return model;
}

Options placementOptions() {
    Options o = atOnce();
    o.radius = 1.0F;
    o.cubeMaps.faceSize = 128;
    return o;
}

class PlacementGLTest : public GLTest {};

TEST_P(PlacementGLTest, TheFirstCubeMapStandsAtTheEyeAndCoversWhatItSees) {
    SmallHost host(gl, loader, corridor(), placementOptions());
    host.lookAt({0, 1.7F, 0}, {10, 1.5F, 0.2F});
    ASSERT_TRUE(host.frame().ok());
    ASSERT_EQ(host.ao().cubeMaps().size(), 1U);
    EXPECT_EQ(host.ao().cubeMaps()[0].position, host.eye());
    gl.Finish();
    ASSERT_TRUE(host.frame().ok());
    EXPECT_EQ(host.ao().cubeMaps().size(), 1U) << "one is enough from its own centre";
    EXPECT_GE(host.ao().statistics().coverage, 0.99F);
}

TEST_P(PlacementGLTest, AWalkRoundACornerPlacesAnotherAndStaysCovered) {
    const Options o = placementOptions();
    SmallHost host(gl, loader, corridor(), o);
    std::size_t known = 0;
    int framesBelow = 0;
    for (int i = 0; i <= 80; ++i) {
        const float x = std::min(0.5F * static_cast<float>(i), 20.0F);
        const float z = std::max(0.5F * static_cast<float>(i) - 20.0F, 0.0F);
        const glm::vec3 eye(x, 1.7F, std::min(z, 18.0F));
        host.lookAt(eye, i < 40 ? eye + glm::vec3(1, 0, 0) : eye + glm::vec3(0, 0, 1));
        ASSERT_TRUE(host.frame().ok());
        gl.Finish();
        const float coverage = host.ao().statistics().coverage;
        const bool placed = host.ao().cubeMaps().size() > known;
        known = host.ao().cubeMaps().size();
        framesBelow =
            coverage >= 0 && coverage < o.cubeMaps.coverage && !placed ? framesBelow + 1 : 0;
        EXPECT_LE(framesBelow, 1) << "frame " << i << ": " << coverage;
    }
    EXPECT_GE(known, 2U);
    EXPECT_LE(known, 8U) << "no more than the corridor needs";
}

TEST_P(PlacementGLTest, AWalkDoesNotWaitForItsCubeMapsToBeComplete) {
    Options o = placementOptions();
    o.estimator = Estimator::RayTraced;
    o.rayTraced.rays = 4096; // there is always something left to do
    o.frameBudget = 4.0F;
    SmallHost host(gl, loader, corridor(), o);
    host.ao().setTexelTracer(std::move(*createTexelTracer(1)));
    const auto enough = [&] { return host.ao().statistics().coverage >= o.cubeMaps.coverage; };
    constexpr int kSteps = 160; // towards the corner and round it
    constexpr int kMostFrames = 500;
    for (int i = 0; i < kSteps || (!enough() && i < kSteps + kMostFrames); ++i) {
        const float way = 14.0F + 0.1F * static_cast<float>(std::min(i, kSteps));
        const float turn = 0.001F * static_cast<float>(i % 2); // never at rest
        const glm::vec3 eye(std::min(way, 20.0F), 1.7F, std::max(way - 20.0F, 0.0F));
        host.lookAt(eye, eye + (way < 20.0F ? glm::vec3(1, 0, turn) : glm::vec3(turn, 0, 1)));
        ASSERT_TRUE(host.frame().ok());
        gl.Finish();
        std::this_thread::sleep_for(std::chrono::milliseconds(1)); // for the tracer's worker
        EXPECT_FALSE(host.ao().statistics().converged);
    }
    EXPECT_TRUE(enough()) << host.ao().statistics().coverage;
    EXPECT_GE(host.ao().cubeMaps().size(), 2U);
    EXPECT_LE(host.ao().cubeMaps().size(), 8U) << "what is on its way is waited for";
}

TEST_P(PlacementGLTest, PlacementCanBeSwitchedOff) {
    Options o = placementOptions();
    o.cubeMaps.place = false;
    SmallHost host(gl, loader, corridor(), o);
    host.lookAt({0, 1.7F, 0}, {10, 1.5F, 0.2F});
    ASSERT_TRUE(host.frame().ok());
    EXPECT_TRUE(host.ao().cubeMaps().empty());
    EXPECT_EQ(host.visibilityAt({10, 1, -2}), 1.0F) << "unshaded means undarkened";
}

TEST_P(PlacementGLTest, FacesWithoutGeometryAreNotModelled) {
    Model model;
    addBox(model, {5, -1, -1}, {7, 1, 1});
    Options o = placementOptions();
    o.cubeMaps.place = false;
    SmallHost host(gl, loader, model, o);
    ASSERT_TRUE(host.ao().addCubeMap({0, 0, 0}).ok());
    EXPECT_EQ(host.ao().cubeMaps()[0].facesModelled, 1) << "the box lies before +X alone";
    EXPECT_EQ(host.ao().cubeMaps()[0].bytes, 3U * 128 * 128) << "3 bytes per texel are kept";
}

AOLIB_FOR_ALL_CONTEXTS(PlacementGLTest);

} // namespace
} // namespace aolib
