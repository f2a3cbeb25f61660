#include "ContextCalls.h"

namespace aolib {
namespace {

using Api = ContextRequest::Api;

class MixedContextsGLTest : public testing::TestWithParam<Api> {};

TEST_P(MixedContextsGLTest, AlternateWithEglInOneProcess) {
    if (const std::string reason = reasonToSkip(GetParam()); !reason.empty()) {
        GTEST_SKIP() << reason;
    }
    ContextRequest request;
    request.defaultFramebuffer = true;
    auto egl = createContext(request);
    ASSERT_TRUE(egl.ok()) << egl.status().message();
    request.api = GetParam();
    auto other = createContext(request);
    ASSERT_TRUE(other.ok()) << other.status().message();
    EXPECT_FALSE((*egl)->isCurrent());
    for (int round = 0; round < 3; ++round) {
        const AoStatus toEgl = (*egl)->makeCurrent();
        ASSERT_TRUE(toEgl.ok()) << toEgl.message();
        EXPECT_FALSE((*other)->isCurrent());
        EXPECT_EQ(clearAndRead(**egl, 1.0f, 0.0f), (std::array<GLubyte, 4>{255, 0, 0, 255}));
        const AoStatus toOther = (*other)->makeCurrent();
        ASSERT_TRUE(toOther.ok()) << toOther.message();
        EXPECT_FALSE((*egl)->isCurrent());
        EXPECT_EQ(clearAndRead(**other, 0.0f, 1.0f), (std::array<GLubyte, 4>{0, 255, 0, 255}));
    }
    egl.value().reset();
    EXPECT_TRUE((*other)->isCurrent());
    EXPECT_EQ(clearAndRead(**other, 1.0f, 1.0f), (std::array<GLubyte, 4>{255, 255, 0, 255}));
}

TEST_P(MixedContextsGLTest, IsDestroyedWhileEglIsCurrent) {
    if (const std::string reason = reasonToSkip(GetParam()); !reason.empty()) {
        GTEST_SKIP() << reason;
    }
    ContextRequest request;
    request.api = GetParam();
    auto other = createContext(request);
    ASSERT_TRUE(other.ok()) << other.status().message();
    request.api = Api::Egl;
    request.defaultFramebuffer = true;
    auto egl = createContext(request);
    ASSERT_TRUE(egl.ok()) << egl.status().message();
    other.value().reset();
    EXPECT_TRUE((*egl)->isCurrent());
    EXPECT_EQ(clearAndRead(**egl, 1.0f, 1.0f), (std::array<GLubyte, 4>{255, 255, 0, 255}));
}

INSTANTIATE_TEST_SUITE_P(Others, MixedContextsGLTest, testing::Values(Api::OsMesa, Api::Glfw),
                         [](const auto& each) { return apiName(each.param); });

} // namespace
} // namespace aolib
