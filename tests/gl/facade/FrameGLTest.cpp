// A frame as hosts draw it: matrices from GL, blending, framebuffers of several kinds.
#include <array>
#include <cmath>

#include <glm/gtc/type_ptr.hpp>

#include "SmallScene.h"

namespace aolib {
namespace {

Options frameOptions() {
    Options options = atOnce();
    options.radius = 1.0F;
    options.cubeMaps.faceSize = 128;
    return options;
}

class FrameGLTest : public GLTest {};

TEST_P(FrameGLTest, DarkensWhereSurfacesMeet) {
    SmallHost host(gl, loader, boxOnFloor(), frameOptions());
    host.lookAt({4, 4, 6}, {0, 0.5F, 0});
    ASSERT_TRUE(host.frame().ok()) << host.ao().lastStatus().message();
    EXPECT_GT(host.visibilityAt({4, 0, 1}), 0.98F);
    EXPECT_LT(host.visibilityAt({1.1F, 0, 0}), 0.9F);
    EXPECT_LT(host.visibilityAt({1.1F, 0, 0}), host.visibilityAt({1.6F, 0, 0}));
}

TEST_P(FrameGLTest, ShadesInOneCallWhatThreeDo) {
    SmallHost host(gl, loader, boxOnFloor(), frameOptions());
    host.lookAt({4, 4, 6}, {0, 0.5F, 0});
    ASSERT_TRUE(host.frame().ok());
    const std::vector<std::uint8_t> three = host.framebuffer().readColour()->pixels;
    host.framebuffer().bind();
    host.renderer().draw(host.view(), host.projection());
    ASSERT_TRUE(host.ao().aoShade(host.view(), host.projection(), ViewId{3}).ok());
    EXPECT_EQ(host.framebuffer().readColour()->pixels, three);
    EXPECT_EQ(host.ao().statistics(ViewId{3}).cubeMapsProjected, 1);
    ASSERT_TRUE(host.ao().aoDrawBegin().ok());
    EXPECT_EQ(host.ao().aoShade(host.view(), host.projection()).code(),
              StatusCode::InvalidCallOrder);
}

TEST_P(FrameGLTest, BlendsByTheFormulaOfTheThesis) {
    SmallHost host(gl, loader, boxOnFloor(), frameOptions());
    host.lookAt({4, 4, 6}, {0, 0.5F, 0});
    host.framebuffer().bind();
    host.renderer().draw(host.view(), host.projection());
    const ByteImage plain = *host.framebuffer().readColour();
    for (const float contrast : {1.0F, 0.4F, 0.0F}) {
        Options options = host.ao().options();
        options.contrast = contrast;
        ASSERT_TRUE(host.ao().setOptions(options).ok());
        ASSERT_TRUE(host.frame().ok());
        const VisibilityImage w = host.visibility();
        const ByteImage shaded = *host.framebuffer().readColour();
        for (std::size_t i = 0; i < w.visibility.size(); ++i) {
            const float factor =
                w.visibility[i] < 0 ? 1.0F : 1 - contrast + contrast * w.visibility[i];
            for (std::size_t c = 0; c < 3; ++c) {
                const auto k = i * static_cast<std::size_t>(plain.channels) + c;
                // One step for the rounding of the product.
                ASSERT_NEAR(shaded.pixels[k], std::round(plain.pixels[k] * factor), 1.0F);
            }
        }
    }
}

TEST_P(FrameGLTest, ReadsTheMatricesOfACompatibilityContext) {
    if (GetParam().profile == ContextRequest::Profile::Core) {
        GTEST_SKIP() << "a core profile has no matrices";
    }
    using MatrixMode = void(APIENTRY*)(GLenum);
    using LoadMatrix = void(APIENTRY*)(const GLfloat*);
    const auto matrixMode = reinterpret_cast<MatrixMode>(loader("glMatrixMode"));
    const auto loadMatrix = reinterpret_cast<LoadMatrix>(loader("glLoadMatrixf"));
    const auto load = [&](const glm::mat4& view, const glm::mat4& projection) {
        matrixMode(0x1701); // GL_PROJECTION
        loadMatrix(glm::value_ptr(projection));
        matrixMode(0x1700); // GL_MODELVIEW
        loadMatrix(glm::value_ptr(view));
    };
    SmallHost host(gl, loader, boxOnFloor(), frameOptions());
    host.lookAt({4, 4, 6}, {0, 0.5F, 0});
    AmbientOcclusion& ao = host.ao();
    const glm::mat4 elsewhere = glm::translate(glm::mat4(1.0F), {9, 9, 9});
    const auto frame = [&](const glm::mat4& atBegin, const glm::mat4& atEnd) {
        host.framebuffer().bind();
        load(atBegin, host.projection());
        EXPECT_TRUE(ao.aoDrawBegin().ok());
        host.renderer().draw(host.view(), host.projection());
        load(atEnd, host.projection());
        return ao.aoDrawEnd(4, 4, 6).code();
    };
    EXPECT_EQ(frame(host.view(), elsewhere), StatusCode::Ok) << "the camera before the draws";
    const float dark = host.visibilityAt({1.1F, 0, 0});
    EXPECT_LT(dark, 0.9F);
    EXPECT_EQ(frame(elsewhere, host.view()), StatusCode::Ok) << "the camera after the draws";
    EXPECT_EQ(host.visibilityAt({1.1F, 0, 0}), dark);
    EXPECT_EQ(frame(elsewhere, elsewhere), StatusCode::InvalidCamera);
}

TEST_P(FrameGLTest, MultisampledHostsGetTheSamePicture) {
    SmallHost single(gl, loader, boxOnFloor(), frameOptions());
    SmallHost multi(gl, loader, boxOnFloor(), frameOptions(), 160, 90, 4);
    for (SmallHost* host : {&single, &multi}) {
        host->lookAt({4, 4, 6}, {0, 0.5F, 0});
        ASSERT_TRUE(host->frame().ok()) << host->ao().lastStatus().message();
    }
    const VisibilityImage a = single.visibility();
    const VisibilityImage b = multi.visibility();
    double sum = 0.0;
    int count = 0;
    for (std::size_t i = 0; i < a.visibility.size(); ++i) {
        if (a.visibility[i] >= 0 && b.visibility[i] >= 0) {
            sum += std::pow(a.visibility[i] - b.visibility[i], 2);
            ++count;
        }
    }
    ASSERT_GT(count, 1000);
    // Depth is resolved to one sample, which lies off the pixel's centre: measured 0.020.
    EXPECT_LT(std::sqrt(sum / count), 0.03);
}

TEST_P(FrameGLTest, AViewportInsideTheFramebufferIsShadedAlone) {
    SmallHost host(gl, loader, boxOnFloor(), frameOptions());
    host.lookAt({4, 4, 6}, {0, 0.5F, 0});
    ASSERT_TRUE(host.frame().ok());
    const VisibilityImage whole = host.visibility();
    // The same picture in the upper right quarter.
    host.framebuffer().bind();
    gl.Viewport(80, 45, 80, 45);
    ASSERT_TRUE(host.ao().aoDrawBegin().ok());
    host.renderer().draw(host.view(), host.projection());
    const ByteImage before = *host.framebuffer().readColour();
    gl.Viewport(80, 45, 80, 45);
    ASSERT_TRUE(host.ao().aoDrawEnd(4, 4, 6).ok());
    const VisibilityImage part = host.visibility();
    EXPECT_EQ(part.width, 80);
    EXPECT_EQ(part.height, 45);
    const ByteImage after = *host.framebuffer().readColour();
    int changedOutside = 0;
    int changedInside = 0;
    for (int y = 0; y < 90; ++y) {
        for (int x = 0; x < 160; ++x) {
            const bool changed = before.at(x, y) != after.at(x, y);
            (x >= 80 && y >= 45 ? changedInside : changedOutside) += changed ? 1 : 0;
        }
    }
    EXPECT_EQ(changedOutside, 0);
    EXPECT_GT(changedInside, 50);
}

TEST_P(FrameGLTest, TheHostsDepthStaysCorrect) {
    SmallHost host(gl, loader, boxOnFloor(), frameOptions());
    host.lookAt({4, 4, 6}, {0, 0.5F, 0});
    const auto depth = [&] {
        std::vector<float> values(160 * 90);
        gl.ReadPixels(0, 0, 160, 90, GL_DEPTH_COMPONENT, GL_FLOAT, values.data());
        return values;
    };
    host.framebuffer().bind();
    host.renderer().draw(host.view(), host.projection());
    const std::vector<float> before = depth();
    ASSERT_TRUE(host.frame().ok());
    host.framebuffer().bind();
    EXPECT_EQ(depth(), before);
}

AOLIB_FOR_ALL_CONTEXTS(FrameGLTest);

} // namespace
} // namespace aolib
