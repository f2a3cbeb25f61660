#include "CheckOptions.h"

#include <limits>

#include <gtest/gtest.h>

namespace aolib {
namespace {

/// Expects the change to be refused with a message that names the option.
template <typename Change>
void expectRefused(const char* name, Change&& change) {
    Options options;
    change(options);
    const AoStatus status = checkOptions(options);
    EXPECT_EQ(status.code(), StatusCode::InvalidOption) << name;
    EXPECT_NE(status.message().find(name), std::string::npos) << status.message();
}

TEST(CheckOptionsTest, DefaultsAreValid) {
    EXPECT_TRUE(checkOptions({}).ok());
}

TEST(CheckOptionsTest, ValuesOutsideTheirRangeAreRefusedByName) {
    expectRefused("radius", [](Options& o) { o.radius = -1.0F; });
    expectRefused("radius", [](Options& o) { o.radius = std::numeric_limits<float>::quiet_NaN(); });
    expectRefused("radius", [](Options& o) { o.radius = std::numeric_limits<float>::infinity(); });
    expectRefused("contrast", [](Options& o) { o.contrast = 1.5F; });
    expectRefused("directions", [](Options& o) { o.horizonSplit.directions = 0; });
    expectRefused("steps", [](Options& o) { o.horizonSplit.steps = 257; });
    expectRefused("step-size", [](Options& o) { o.horizonSplit.stepSize = -1.0F; });
    expectRefused("face-size", [](Options& o) { o.cubeMaps.faceSize = 15; });
    expectRefused("nearest", [](Options& o) { o.cubeMaps.nearest = 0; });
    expectRefused("coverage", [](Options& o) { o.cubeMaps.coverage = -0.1F; });
    expectRefused("memory-budget", [](Options& o) { o.cubeMaps.memoryBudget = -1.0F; });
    expectRefused("blur-size", [](Options& o) { o.blur.size = 17; });
    expectRefused("blur-size", [](Options& o) { o.blur.size = 4; });
    expectRefused("falloff", [](Options& o) { o.falloff = static_cast<Falloff>(9); });
    expectRefused("backbone", [](Options& o) { o.backbone = static_cast<Backbone>(9); });
    expectRefused("estimator", [](Options& o) { o.estimator = static_cast<Estimator>(9); });
    expectRefused("debug-view", [](Options& o) { o.debugView = static_cast<DebugView>(99); });
}

TEST(CheckOptionsTest, TheMemoryBudgetHoldsACubeMapAtLeast) {
    // Six faces, three bytes a texel: 4.5 MiB, and some bytes for pages.
    expectRefused("memory-budget", [](Options& o) { o.cubeMaps.memoryBudget = 4.5F; });
    expectRefused("memory-budget", [](Options& o) {
        o.cubeMaps.memoryBudget = 64.0F;
        o.cubeMaps.faceSize = 4096;
    });
    Options options;
    options.cubeMaps.memoryBudget = 4.6F;
    EXPECT_TRUE(checkOptions(options).ok());
    options.cubeMaps.memoryBudget = 0.0F; // no limit
    options.cubeMaps.faceSize = 4096;
    EXPECT_TRUE(checkOptions(options).ok());
    options.cubeMaps.memoryBudget = Options().cubeMaps.memoryBudget;
    EXPECT_TRUE(checkOptions(options).ok()) << "the default suits every size of faces";
}

} // namespace
} // namespace aolib
