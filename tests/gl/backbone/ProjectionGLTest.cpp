// What a cube map holds reaches the pixels: no leak through walls, the better of two wins.
#include <cmath>
#include <utility>

#include "SmallScene.h"

namespace aolib {
namespace {

Options projectionOptions() {
    Options o = atOnce();
    o.radius = 1.5F;
    o.cubeMaps.faceSize = 256;
    o.cubeMaps.place = false;
    o.cubeMaps.screenSpaceFallback = false; // what is projected alone
    o.blur.enabled = false;
    return o;
}

Model courtyard() {
    Model model;
    addQuad(model, {-10, 0, -10}, {-10, 0, 10}, {10, 0, 10}, {10, 0, -10});
    addBox(model, {-3, 0, -4}, {-1, 3, -2});
    addBox(model, {2, 0, -5}, {3, 1, -3});
    return model;
}

class ProjectionGLTest : public GLTest {
protected:
    /// W of the cube map by bilinear lookup in the direction of a world position.
    static float lookUp(const CubeMapImage& cube, const glm::vec3& point) {
        return cube.visibility[texelTowards(cube, point)];
    }
};

TEST_P(ProjectionGLTest, PixelsShowTheirTexels) {
    SmallHost host(gl, loader, courtyard(), projectionOptions());
    const CubeMapId id = *host.ao().addCubeMap({1, 2, 3});
    host.lookAt({1, 2, 3}, {0, 0, -4});
    ASSERT_TRUE(host.frame().ok());
    const CubeMapImage cube = *host.ao().readCubeMap(id);
    for (const glm::vec3 point : {glm::vec3(0.5F, 0, -3), glm::vec3(-0.7F, 0, -3),
                                  glm::vec3(1.7F, 0, -4), glm::vec3(-2, 1, -2)}) {
        // Neighbouring texels are mixed; W changes by less than this over one of them.
        EXPECT_NEAR(host.visibilityAt(point), lookUp(cube, point), 0.03F);
    }
}

TEST_P(ProjectionGLTest, NothingIsProjectedThroughAWall) {
    Model model = courtyard();
    addQuad(model, {-10, 0, 0}, {10, 0, 0}, {10, 9, 0}, {-10, 9, 0});
    SmallHost host(gl, loader, model, projectionOptions());
    // The cube map stands on the far side of the wall z = 0, the camera on the near side of it.
    ASSERT_TRUE(host.ao().addCubeMap({0, 2, 5}).ok());
    host.lookAt({0, 2, -8}, {0, 1, 0});
    ASSERT_TRUE(host.frame().ok());
    const VisibilityImage image = host.visibility();
    std::size_t shaded = 0;
    for (const float w : image.visibility) {
        shaded += w >= 0.0F && w < 1.0F ? 1 : 0;
    }
    // At the wall's foot a texel of the floor beyond reaches under it, by less than its own width:
    // a row of pixels, measured 0.7% of the picture.
    EXPECT_LT(shaded, image.visibility.size() / 100);
    gl.Finish();
    ASSERT_TRUE(host.frame().ok());
    EXPECT_LT(host.ao().statistics().coverage, 0.02F);
}

TEST_P(ProjectionGLTest, OrderOfPlacementDoesNotMatter) {
    const auto render = [&](const std::vector<glm::vec3>& positions) {
        SmallHost host(gl, loader, courtyard(), projectionOptions());
        for (const glm::vec3& position : positions) {
            EXPECT_TRUE(host.ao().addCubeMap(position).ok());
        }
        host.lookAt({1, 3, 4}, {0, 0, -4});
        EXPECT_TRUE(host.frame().ok());
        EXPECT_EQ(host.ao().statistics().cubeMapsProjected, 3);
        return host.visibility().visibility;
    };
    const glm::vec3 a(1, 2, 3);
    const glm::vec3 b(-4, 2, 0);
    const glm::vec3 c(0, 5, -3);
    const auto forward = render({a, b, c});
    EXPECT_EQ(forward, render({c, b, a})) << "the best quality wins, not the last pass";
    EXPECT_NE(forward, render({a, a, a}));
}

TEST_P(ProjectionGLTest, BothMethodsGiveTheSamePixels) {
    const auto render = [&](ProjectionMethod method) {
        Options o = projectionOptions();
        o.cubeMaps.projection = method;
        SmallHost host(gl, loader, courtyard(), o);
        for (const glm::vec3 position :
             {glm::vec3(1, 2, 3), glm::vec3(-4, 2, 0), glm::vec3(0, 5, -3)}) {
            EXPECT_TRUE(host.ao().addCubeMap(position).ok());
        }
        host.lookAt({1, 3, 4}, {0, 0, -4});
        EXPECT_TRUE(host.frame().ok());
        return std::pair(host.framebuffer().readColour()->pixels, host.visibility().visibility);
    };
    const auto [single, singleW] = render(ProjectionMethod::SinglePass);
    const auto [pingPong, pingPongW] = render(ProjectionMethod::PingPong);
    EXPECT_EQ(single, pingPong) << "as the host isVisible them";
    EXPECT_EQ(singleW, pingPongW) << "as they are read back";
}

/// Odd sizes, so that the last row and column have no sample of their own.
TEST_P(ProjectionGLTest, HalfTheResolutionDiffersAtEdgesAlone) {
    Options o = projectionOptions();
    o.estimator = Estimator::HorizonSplit;
    o.cubeMaps.faceSize = 128;
    SmallHost host(gl, loader, courtyard(), o, 161, 91);
    host.lookAt({1, 3, 4}, {0, 0, -4});
    for (const glm::vec3 position : {glm::vec3(1, 2, 3), glm::vec3(-4, 2, 0)}) {
        ASSERT_TRUE(host.ao().addCubeMap(position).ok());
    }
    const auto picture = [&](bool half, ProjectionMethod method) {
        o.cubeMaps.halfResolution = half;
        o.cubeMaps.projection = method;
        EXPECT_TRUE(host.ao().setOptions(o).ok());
        EXPECT_TRUE(host.frame().ok());
        // What was blended is what is read.
        const ByteImage colours = *host.framebuffer().readColour();
        return std::pair(host.visibility().visibility, colours.pixels);
    };
    const auto [whole, wholeColours] = picture(false, ProjectionMethod::SinglePass);
    const auto [half, halfColours] = picture(true, ProjectionMethod::SinglePass);
    double squares = 0.0;
    std::size_t above = 0;
    std::size_t differing = 0;
    for (std::size_t i = 0; i < whole.size(); ++i) {
        EXPECT_EQ(half[i] < 0.0F, whole[i] < 0.0F);
        const double difference = half[i] - whole[i];
        squares += difference * difference;
        above += std::abs(difference) > 0.02 ? 1 : 0;
        differing += half[i] != whole[i] ? 1 : 0;
        EXPECT_EQ(half[i] == whole[i] && halfColours[3 * i] != wholeColours[3 * i], false) << i;
    }
    EXPECT_GT(differing, whole.size() / 20) << "else this shows nothing";
    EXPECT_LT(above, whole.size() / 50);
    EXPECT_LT(std::sqrt(squares / static_cast<double>(whole.size())), 0.01);
    EXPECT_EQ(picture(true, ProjectionMethod::PingPong).first, half);
    EXPECT_EQ(picture(false, ProjectionMethod::SinglePass).first, whole);
}

TEST_P(ProjectionGLTest, OnlyTheNearestAreProjected) {
    Options o = projectionOptions();
    o.cubeMaps.nearest = 2;
    SmallHost host(gl, loader, courtyard(), o);
    for (const float x : {-5.0F, -4.0F, 4.0F, 5.0F}) {
        ASSERT_TRUE(host.ao().addCubeMap({x, 2, 3}).ok());
    }
    host.lookAt({1, 3, 4}, {0, 0, -4});
    ASSERT_TRUE(host.frame().ok());
    EXPECT_EQ(host.ao().statistics().cubeMapsProjected, 2);
}

TEST_P(ProjectionGLTest, TheBlurKeepsEdgesAndFlatAreas) {
    Options sharp = projectionOptions();
    Options blurred = projectionOptions();
    blurred.blur.enabled = true;
    const auto render = [&](const Options& o) {
        SmallHost host(gl, loader, courtyard(), o);
        EXPECT_TRUE(host.ao().addCubeMap({1, 2, 3}).ok());
        host.lookAt({1, 2, 3}, {0, 0, -4});
        EXPECT_TRUE(host.frame().ok());
        return std::pair(host.visibilityAt({0.5F, 0, -1}), host.visibilityAt({-2, 2.9F, -2}));
    };
    const auto [floorSharp, boxSharp] = render(sharp);
    const auto [floorBlurred, boxBlurred] = render(blurred);
    EXPECT_NEAR(floorSharp, floorBlurred, 0.02F);
    EXPECT_NEAR(boxSharp, boxBlurred, 0.02F) << "the box must not take the dark ground behind it";
}

AOLIB_FOR_ALL_CONTEXTS(ProjectionGLTest);

} // namespace
} // namespace aolib
