#include "ContextCalls.h"

#include <thread>
#include <tuple>

namespace aolib {
namespace {

using Api = ContextRequest::Api;
using Profile = ContextRequest::Profile;

class GlContextGLTest : public testing::TestWithParam<std::tuple<Api, Profile>> {
protected:
    void SetUp() override {
        request_.api = std::get<0>(GetParam());
        request_.profile = std::get<1>(GetParam());
        if (const std::string reason = reasonToSkip(request_.api); !reason.empty()) {
            GTEST_SKIP() << reason;
        }
    }

    ContextRequest request_;
};

TEST_P(GlContextGLTest, IsCurrentAndDescribesItself) {
    const auto context = createContext(request_);
    ASSERT_TRUE(context.ok()) << context.status().message();
    EXPECT_TRUE((*context)->isCurrent());

    const auto getString = lookUp<PFNGLGETSTRINGPROC>(**context, "glGetString");
    ASSERT_NE(getString, nullptr);
    ASSERT_NE(getString(GL_VERSION), nullptr);
    const ContextInfo& info = (*context)->info();
    EXPECT_EQ(info.version, reinterpret_cast<const char*>(getString(GL_VERSION)));
    EXPECT_EQ(info.renderer, reinterpret_cast<const char*>(getString(GL_RENDERER)));
    EXPECT_GE(std::tie(info.major, info.minor), std::tie(request_.major, request_.minor));
    EXPECT_EQ(info.profile, request_.profile);

    const std::string line = (*context)->describe();
    EXPECT_EQ(line.rfind(apiName(request_.api), 0), 0u) << line;
    EXPECT_NE(line.find(info.renderer), std::string::npos) << line;
    RecordProperty("context", line);
}

TEST_P(GlContextGLTest, OnlyCompatibilityHasTheFixedPipeline) {
    const auto context = createContext(request_);
    ASSERT_TRUE(context.ok()) << context.status().message();
    constexpr GLenum modelView = 0x1700; // GL_MODELVIEW, which glcorearb.h leaves out
    const auto matrixMode =
        reinterpret_cast<void (*)(GLenum)>((*context)->getProcAddress("glMatrixMode"));
    const auto getError = lookUp<PFNGLGETERRORPROC>(**context, "glGetError");
    if (request_.profile == Profile::Compatibility) {
        ASSERT_NE(matrixMode, nullptr);
        matrixMode(modelView);
        EXPECT_EQ(getError(), GLenum{GL_NO_ERROR});
    } else if (matrixMode != nullptr) {
        matrixMode(modelView);
        EXPECT_EQ(getError(), GLenum{GL_INVALID_OPERATION});
    }
}

TEST_P(GlContextGLTest, TwoContextsAlternateWithStateOfTheirOwn) {
    const auto first = createContext(request_);
    ASSERT_TRUE(first.ok()) << first.status().message();
    lookUp<PFNGLCLEARCOLORPROC>(**first, "glClearColor")(0.25f, 0.0f, 0.0f, 1.0f);
    {
        const auto second = createContext(request_);
        ASSERT_TRUE(second.ok()) << second.status().message();
        EXPECT_FALSE((*first)->isCurrent());
        lookUp<PFNGLCLEARCOLORPROC>(**second, "glClearColor")(0.75f, 0.0f, 0.0f, 1.0f);
        for (int round = 0; round < 3; ++round) {
            ASSERT_TRUE((*first)->makeCurrent().ok());
            EXPECT_EQ(clearRed(**first), 0.25f);
            ASSERT_TRUE((*second)->makeCurrent().ok());
            EXPECT_TRUE((*second)->isCurrent());
            EXPECT_EQ(clearRed(**second), 0.75f);
        }
    }
    EXPECT_FALSE((*first)->isCurrent());
    ASSERT_TRUE((*first)->makeCurrent().ok());
    EXPECT_EQ(clearRed(**first), 0.25f);
}

TEST_P(GlContextGLTest, DestroyingAnotherContextLeavesTheCurrentOneCurrent) {
    auto first = createContext(request_);
    ASSERT_TRUE(first.ok()) << first.status().message();
    const auto second = createContext(request_);
    ASSERT_TRUE(second.ok()) << second.status().message();
    lookUp<PFNGLCLEARCOLORPROC>(**second, "glClearColor")(0.5f, 0.0f, 0.0f, 1.0f);
    first.value().reset();
    EXPECT_TRUE((*second)->isCurrent());
    EXPECT_EQ(clearRed(**second), 0.5f);
}

TEST_P(GlContextGLTest, DoneCurrentReleasesOnlyItself) {
    const auto first = createContext(request_);
    ASSERT_TRUE(first.ok()) << first.status().message();
    const auto second = createContext(request_);
    ASSERT_TRUE(second.ok()) << second.status().message();
    (*first)->doneCurrent();
    EXPECT_TRUE((*second)->isCurrent());
    (*second)->doneCurrent();
    EXPECT_FALSE((*second)->isCurrent());
}

TEST_P(GlContextGLTest, DefaultFramebufferHoldsWhatIsDrawn) {
    request_.defaultFramebuffer = true;
    request_.width = 40;
    request_.height = 30;
    const auto context = createContext(request_);
    ASSERT_TRUE(context.ok()) << context.status().message();
    EXPECT_TRUE((*context)->info().defaultFramebuffer);
    EXPECT_EQ((*context)->info().width, 40);
    EXPECT_EQ((*context)->info().height, 30);

    std::array<GLint, 4> viewport{};
    lookUp<PFNGLGETINTEGERVPROC>(**context, "glGetIntegerv")(GL_VIEWPORT, viewport.data());
    EXPECT_EQ(viewport, (std::array<GLint, 4>{0, 0, 40, 30}));
    EXPECT_EQ(clearAndRead(**context, 1.0f, 0.0f), (std::array<GLubyte, 4>{255, 0, 0, 255}));
    EXPECT_EQ(clearAndRead(**context, 0.0f, 1.0f), (std::array<GLubyte, 4>{0, 255, 0, 255}));
}

TEST_P(GlContextGLTest, DefaultFramebufferHasDepthAndStencil) {
    request_.defaultFramebuffer = true;
    const auto context = createContext(request_);
    ASSERT_TRUE(context.ok()) << context.status().message();
    const auto bits = [&](GLenum attachment, GLenum size) {
        GLint value = 0;
        lookUp<PFNGLGETFRAMEBUFFERATTACHMENTPARAMETERIVPROC>(
            **context, "glGetFramebufferAttachmentParameteriv")(GL_FRAMEBUFFER, attachment, size,
                                                                &value);
        return value;
    };
    EXPECT_GE(bits(GL_DEPTH, GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE), 24);
    EXPECT_GE(bits(GL_STENCIL, GL_FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE), 8);
}

TEST_P(GlContextGLTest, CanMoveToAnotherThread) {
    if (request_.api == Api::Glfw) {
        GTEST_SKIP() << "GLFW contexts belong to the main thread, by their contract";
    }
    const auto context = createContext(request_);
    ASSERT_TRUE(context.ok()) << context.status().message();
    lookUp<PFNGLCLEARCOLORPROC>(**context, "glClearColor")(0.5f, 0.0f, 0.0f, 1.0f);
    (*context)->doneCurrent();
    std::thread([&] {
        const AoStatus status = (*context)->makeCurrent();
        EXPECT_TRUE(status.ok()) << status.message();
        EXPECT_EQ(clearRed(**context), 0.5f);
        (*context)->doneCurrent();
    }).join();
    EXPECT_TRUE((*context)->makeCurrent().ok());
}

TEST_P(GlContextGLTest, VersionThatNobodyHasIsRefusedWithASentence) {
    request_.major = 9;
    request_.minor = 9;
    const auto context = createContext(request_);
    ASSERT_FALSE(context.ok());
    EXPECT_EQ(context.status().code(), StatusCode::NoContext);
    const std::string message = context.status().message();
    EXPECT_NE(message.find(apiName(request_.api)), std::string::npos) << message;
    EXPECT_NE(message.find("9.9"), std::string::npos) << message;
}

TEST_P(GlContextGLTest, SizesThatMakeNoSenseAreRefused) {
    request_.width = 0;
    const auto flat = createContext(request_);
    ASSERT_FALSE(flat.ok());
    EXPECT_EQ(flat.status().code(), StatusCode::InvalidOption);
    EXPECT_NE(flat.status().message().find("0 x 16"), std::string::npos);

    request_.width = 16;
    request_.samples = -1;
    const auto negative = createContext(request_);
    ASSERT_FALSE(negative.ok());
    EXPECT_EQ(negative.status().code(), StatusCode::InvalidOption);
}

std::string parameterName(const testing::TestParamInfo<std::tuple<Api, Profile>>& info) {
    return std::string(apiName(std::get<0>(info.param))) +
           (std::get<1>(info.param) == Profile::Core ? "Core" : "Compatibility");
}

INSTANTIATE_TEST_SUITE_P(Apis, GlContextGLTest,
                         testing::Combine(testing::Values(Api::Egl, Api::OsMesa, Api::Glfw),
                                          testing::Values(Profile::Core, Profile::Compatibility)),
                         parameterName);

} // namespace
} // namespace aolib
