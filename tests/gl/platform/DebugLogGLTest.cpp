#include "platform/DebugLog.h"
#include "platform/GlContext.h"

#include <GL/glcorearb.h>
#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <utility>

namespace aolib {
namespace {

class DebugLogGLTest : public testing::Test {
protected:
    void SetUp() override {
        ContextRequest request;
        request.debug = true;
        auto made = createOffscreenContext(request);
        ASSERT_TRUE(made.ok()) << made.status().message();
        context_ = std::move(made.value());
    }

    template <typename Function>
    Function function(const char* name) const {
        return reinterpret_cast<Function>(context_->getProcAddress(name));
    }

    /// An error that every driver reports: no such capability.
    void provoke() const { function<PFNGLENABLEPROC>("glEnable")(0xFFFF); }

    void insert(GLenum severity, const char* text) const {
        function<PFNGLDEBUGMESSAGEINSERTPROC>("glDebugMessageInsert")(
            GL_DEBUG_SOURCE_APPLICATION, GL_DEBUG_TYPE_OTHER, 7, severity, -1, text);
    }

    std::unique_ptr<GlContext> context_;
};

TEST_F(DebugLogGLTest, IsSilentWhenNothingIsWrong) {
    const auto log = DebugLog::install(context_->loader());
    ASSERT_TRUE(log.ok()) << log.status().message();
    function<PFNGLCLEARCOLORPROC>("glClearColor")(0.0f, 0.0f, 0.0f, 1.0f);
    EXPECT_TRUE((*log)->empty()) << (*log)->text();
    EXPECT_EQ((*log)->text(), "");
}

TEST_F(DebugLogGLTest, CollectsTheDriversErrors) {
    const auto log = DebugLog::install(context_->loader());
    ASSERT_TRUE(log.ok()) << log.status().message();
    provoke();
    ASSERT_EQ((*log)->messages().size(), 1u) << (*log)->text();
    EXPECT_TRUE((*log)->messages()[0].error);
    EXPECT_EQ((*log)->messages()[0].severity, DebugLog::Severity::High);
    EXPECT_NE((*log)->text().find("high error"), std::string::npos) << (*log)->text();
    (*log)->clear();
    EXPECT_TRUE((*log)->empty());
}

TEST_F(DebugLogGLTest, LeavesOutNotificationsOnly) {
    const auto log = DebugLog::install(context_->loader());
    ASSERT_TRUE(log.ok()) << log.status().message();
    insert(GL_DEBUG_SEVERITY_NOTIFICATION, "a note");
    EXPECT_TRUE((*log)->empty()) << (*log)->text();
    insert(GL_DEBUG_SEVERITY_LOW, "a remark");
    insert(GL_DEBUG_SEVERITY_MEDIUM, "a warning");
    EXPECT_EQ((*log)->text(), "low message 7: a remark\nmedium message 7: a warning\n");
}

TEST_F(DebugLogGLTest, GivesTheSlotBack) {
    const auto outer = DebugLog::install(context_->loader());
    ASSERT_TRUE(outer.ok()) << outer.status().message();
    {
        const auto inner = DebugLog::install(context_->loader());
        ASSERT_TRUE(inner.ok()) << inner.status().message();
        provoke();
        EXPECT_EQ((*inner)->messages().size(), 1u);
        EXPECT_TRUE((*outer)->empty());
    }
    provoke();
    EXPECT_EQ((*outer)->messages().size(), 1u);
}

TEST_F(DebugLogGLTest, AnEmptyLoaderIsRefused) {
    const auto log = DebugLog::install([](const char*) -> void* { return nullptr; });
    ASSERT_FALSE(log.ok());
    EXPECT_EQ(log.status().code(), StatusCode::NoContext);
}

TEST_F(DebugLogGLTest, AContextWithoutDebugOutputIsRefused) {
    const GlContext* context = context_.get();
    const auto log = DebugLog::install([context](const char* name) -> void* {
        return std::string_view(name) == "glDebugMessageCallback" ? nullptr
                                                                  : context->getProcAddress(name);
    });
    ASSERT_FALSE(log.ok());
    EXPECT_EQ(log.status().code(), StatusCode::MissingCapability);
}

} // namespace
} // namespace aolib
