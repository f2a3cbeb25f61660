#include "ContextCalls.h"

namespace aolib {
namespace {

using Api = ContextRequest::Api;

TEST(EglContextGLTest, HasNoDefaultFramebufferUnlessAskedFor) {
    const auto context = createContext({});
    ASSERT_TRUE(context.ok()) << context.status().message();
    EXPECT_FALSE((*context)->info().defaultFramebuffer);
    EXPECT_EQ((*context)->info().width, 0);
}

TEST(EglContextGLTest, DebugContextSaysSo) {
    ContextRequest request;
    EXPECT_FALSE((*createContext(request))->info().debug);
    request.debug = true;
    const auto context = createContext(request);
    ASSERT_TRUE(context.ok()) << context.status().message();
    EXPECT_TRUE((*context)->info().debug);
}

TEST(EglContextGLTest, SamplesReachTheDefaultFramebuffer) {
    ContextRequest request;
    request.defaultFramebuffer = true;
    request.samples = 4;
    const auto context = createContext(request);
    if (!context.ok()) {
        GTEST_SKIP() << "NOT TESTED: " << context.status().message();
    }
    GLint samples = 0;
    lookUp<PFNGLGETINTEGERVPROC>(**context, "glGetIntegerv")(GL_SAMPLES, &samples);
    EXPECT_GE(samples, 4);
}

/// Sets the variable that picks an EGL device for one test, and puts the old value back.
class EglDeviceGLTest : public testing::Test {
protected:
    void SetUp() override {
        const char* value = std::getenv("AOLIB_EGL_DEVICE");
        before_ = value == nullptr ? "" : value;
    }
    void TearDown() override { setenv("AOLIB_EGL_DEVICE", before_.c_str(), 1); }

    std::string before_;
};

TEST_F(EglDeviceGLTest, IndexPicksTheDeviceOrIsRefused) {
    setenv("AOLIB_EGL_DEVICE", "0", 1);
    const auto context = createContext({});
    if (context.ok()) {
        EXPECT_EQ((*context)->platformName(), "EGL device 0");
    } else {
        EXPECT_NE(context.status().message().find("device"), std::string::npos)
            << context.status().message();
    }
}

TEST_F(EglDeviceGLTest, NonsenseIsRefused) {
    for (const char* wanted : {"1000", "-1", "first", "0x", "0 "}) {
        setenv("AOLIB_EGL_DEVICE", wanted, 1);
        const auto context = createContext({});
        ASSERT_FALSE(context.ok()) << wanted;
        EXPECT_EQ(context.status().code(), StatusCode::InvalidOption) << wanted;
        EXPECT_NE(context.status().message().find(wanted), std::string::npos);
    }
}

TEST(OsMesaContextGLTest, SamplesAreRefused) {
    ContextRequest request;
    request.api = Api::OsMesa;
    if (const std::string reason = reasonToSkip(request.api); !reason.empty()) {
        GTEST_SKIP() << reason;
    }
    request.samples = 4;
    const auto context = createContext(request);
    ASSERT_FALSE(context.ok());
    EXPECT_EQ(context.status().code(), StatusCode::InvalidOption);
}

TEST(GlfwContextGLTest, WithoutADisplayServerItSaysSo) {
    ContextRequest request;
    request.api = Api::Glfw;
    if (reasonToSkip(request.api).empty()) {
        GTEST_SKIP() << "NOT TESTED: there is a display server";
    }
    const auto context = createContext(request);
    ASSERT_FALSE(context.ok());
    EXPECT_EQ(context.status().message().rfind("GLFW: ", 0), 0u) << context.status().message();
}

TEST(OffscreenContextGLTest, FallsBackToOsMesaWhereEglFails) {
    if (const std::string reason = reasonToSkip(Api::OsMesa); !reason.empty()) {
        GTEST_SKIP() << reason;
    }
    const char* value = std::getenv("AOLIB_EGL_DEVICE");
    const std::string before = value == nullptr ? "" : value;
    setenv("AOLIB_EGL_DEVICE", "no such device", 1);
    const auto context = createOffscreenContext({});
    setenv("AOLIB_EGL_DEVICE", before.c_str(), 1);
    ASSERT_TRUE(context.ok()) << context.status().message();
    EXPECT_EQ((*context)->api(), Api::OsMesa);
}

} // namespace
} // namespace aolib
