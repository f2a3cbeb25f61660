// Each debug view shows what it says.
#include <set>

#include "SmallScene.h"

namespace aolib {
namespace {

class DebugViewGLTest : public GLTest {
protected:
    void SetUp() override {
        GLTest::SetUp();
        if (IsSkipped()) {
            return;
        }
        Options options = atOnce();
        options.radius = 1.0F;
        options.cubeMaps.faceSize = 128;
        host_ = std::make_unique<SmallHost>(gl, loader, boxOnFloor(), options);
        host_->lookAt({4, 4, 6}, {0, 0.5F, 0});
    }
    void TearDown() override {
        host_.reset();
        GLTest::TearDown();
    }

    ByteImage show(DebugView view, bool outlines = false) {
        Options options = host_->ao().options();
        options.debugView = view;
        options.cubeMaps.outlines = outlines;
        EXPECT_TRUE(host_->ao().setOptions(options).ok());
        EXPECT_TRUE(host_->frame().ok());
        return *host_->framebuffer().readColour();
    }
    /// Red, green, blue at a world position.
    glm::ivec3 at(const ByteImage& image, const glm::vec3& position) const {
        const glm::vec4 clip = host_->projection() * host_->view() * glm::vec4(position, 1.0F);
        const int x =
            static_cast<int>((clip.x / clip.w * 0.5F + 0.5F) * static_cast<float>(image.width));
        const int y =
            static_cast<int>((clip.y / clip.w * 0.5F + 0.5F) * static_cast<float>(image.height));
        return {image.at(x, y, 0), image.at(x, y, 1), image.at(x, y, 2)};
    }

    std::unique_ptr<SmallHost> host_;
};

TEST_P(DebugViewGLTest, NormalsAreTheSurfacesOwn) {
    const ByteImage image = show(DebugView::Normals);
    const auto expectNormal = [&](const glm::vec3& position, const glm::vec3& normal) {
        const glm::vec3 shown = glm::vec3(at(image, position)) / 127.5F - 1.0F;
        // Half a step of 8 bits in each channel, and the depth buffer's rounding.
        EXPECT_LT(glm::length(shown - normal), 0.03F);
    };
    expectNormal({3, 0, 1}, {0, 1, 0});
    expectNormal({0, 2, 0}, {0, 1, 0});
    expectNormal({1, 1, 0}, {1, 0, 0});
    expectNormal({0, 1, 1}, {0, 0, 1});
}

TEST_P(DebugViewGLTest, PositionsRepeatOncePerRadius) {
    const ByteImage image = show(DebugView::Positions);
    const glm::ivec3 here = at(image, {2.4F, 0, 1.3F});
    const glm::ivec3 next = at(image, {3.4F, 0, 1.3F});
    // A pixel covers about 0.06 units here.
    EXPECT_NEAR(here.x, 0.4F * 255, 30);
    EXPECT_NEAR(here.z, 0.3F * 255, 30);
    EXPECT_NEAR(here.x, next.x, 35);
}

TEST_P(DebugViewGLTest, AmbientOcclusionIsGreyOnWhite) {
    const ByteImage image = show(DebugView::AmbientOcclusion);
    const glm::ivec3 dark = at(image, {1.1F, 0, 0});
    EXPECT_EQ(dark.x, dark.y);
    EXPECT_EQ(dark.y, dark.z);
    EXPECT_LT(dark.x, 230);
    EXPECT_EQ(image.at(image.width / 2, image.height - 1), 255) << "background";
}

TEST_P(DebugViewGLTest, CoverageShowsTheUnshadedInRed) {
    Options options = host_->ao().options();
    options.cubeMaps.place = false;
    ASSERT_TRUE(host_->ao().setOptions(options).ok());
    glm::ivec3 colour = at(show(DebugView::Coverage), {3, 0, 1});
    EXPECT_GT(colour.x, 200);
    EXPECT_LT(colour.y, 60);
    ASSERT_TRUE(host_->ao().addCubeMap({4, 4, 6}).ok());
    colour = at(show(DebugView::Coverage), {3, 0, 1});
    EXPECT_EQ(colour.x, colour.y);
}

TEST_P(DebugViewGLTest, EdgesAreGreenWhereSurfacesEnd) {
    const ByteImage image = show(DebugView::Edges);
    int green = 0;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            green += image.at(x, y, 1) > image.at(x, y, 0) + 80 ? 1 : 0;
        }
    }
    EXPECT_GT(green, 50);
    EXPECT_LT(green, image.width * image.height / 5);
    const glm::ivec3 flat = at(image, {3, 0, 1});
    EXPECT_EQ(flat.x, flat.y) << "no edge in the middle of the floor";
}

TEST_P(DebugViewGLTest, FacesHaveTheirColours) {
    const ByteImage image = show(DebugView::Faces);
    std::set<std::tuple<int, int, int>> colours;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            colours.emplace(image.at(x, y, 0), image.at(x, y, 1), image.at(x, y, 2));
        }
    }
    // Three faces look down at the box, each bright and, at its border, dark; the white background.
    EXPECT_GE(colours.size(), 4U);
    EXPECT_LE(colours.size(), 14U);
}

TEST_P(DebugViewGLTest, QualityFallsWithDistance) {
    const ByteImage image = show(DebugView::Quality);
    const glm::ivec3 near = at(image, {3, 0, 3});
    const glm::ivec3 far = at(image, {-6, 0, -6});
    EXPECT_GT(near.y - near.x, far.y - far.x) << "greener is better";
}

TEST_P(DebugViewGLTest, OutlinesAppearWhereACubeMapStands) {
    const ByteImage without = show(DebugView::Off);
    ASSERT_TRUE(host_->ao().addCubeMap({2, 1, 2}).ok());
    Options options = host_->ao().options();
    options.cubeMaps.place = false;
    ASSERT_TRUE(host_->ao().setOptions(options).ok());
    const ByteImage with = show(DebugView::Off, true);
    const ByteImage again = show(DebugView::Off, false);
    int drawn = 0;
    for (std::size_t i = 0; i < with.pixels.size(); ++i) {
        drawn += with.pixels[i] != again.pixels[i] ? 1 : 0;
    }
    EXPECT_GT(drawn, 10);
    EXPECT_LT(drawn, 2000);
}

AOLIB_FOR_ALL_CONTEXTS(DebugViewGLTest);

} // namespace
} // namespace aolib
