#include "backbone/cubemaps/Eviction.h"

#include <vector>

#include <gtest/gtest.h>

namespace aolib {
namespace {

/// Cube maps in use that have been complete for long, the first the most useful.
class EvictionTest : public testing::Test {
protected:
    EvictionTest() {
        for (const float usefulness : {0.8F, 0.1F, 0.01F}) {
            cubeMaps_.push_back(
                {.inUse = true, .usage = {.usefulness = usefulness, .feedbackComplete = 1000}});
        }
    }

    CubeMapUsage& usage(std::size_t i) { return cubeMaps_[i].usage; }
    /// The number of the victim; -1 for none.
    int victim(EvictionReason reason = EvictionReason::NewCubeMap) const {
        const auto found = Eviction::victim(cubeMaps_, reason);
        return found ? static_cast<int>(*found) : -1;
    }

    std::vector<Eviction::Candidate> cubeMaps_;
};

TEST_F(EvictionTest, TheLeastUsefulGoesFirst) {
    EXPECT_EQ(victim(), 2);
    usage(2).usefulness = 0.5F;
    EXPECT_EQ(victim(), 1);
}

TEST_F(EvictionTest, ThoseByHandStayUnlessTheBudgetShrinks) {
    cubeMaps_[2].pinned = true;
    EXPECT_EQ(victim(), 1);
    cubeMaps_[0].pinned = cubeMaps_[1].pinned = true;
    EXPECT_EQ(victim(), -1);
    cubeMaps_[0].pinned = false;
    EXPECT_EQ(victim(EvictionReason::Budget), 0) << "those by hand last";
    cubeMaps_[0].pinned = true;
    EXPECT_EQ(victim(EvictionReason::Budget), 2);
}

TEST_F(EvictionTest, WhatWasJustComputedIsShownFirst) {
    usage(2).feedbackComplete = 3;
    EXPECT_EQ(victim(), 1);
    usage(0).feedbackComplete = usage(1).feedbackComplete = 3;
    EXPECT_EQ(victim(), -1);
    for (Eviction::Candidate& one : cubeMaps_) {
        one.inUse = false;
    }
    EXPECT_EQ(victim(), 2) << "it is shown nowhere";
}

TEST_F(EvictionTest, OneThatGoesAlreadyIsTheOne) {
    cubeMaps_[0].fadingOut = true;
    EXPECT_EQ(victim(), 0);
}

TEST_F(EvictionTest, DetailPushesOutOnlyWhatNobodySees) {
    EXPECT_EQ(victim(EvictionReason::Page), -1);
    usage(1).feedbackUnseen = 1000;
    EXPECT_EQ(victim(EvictionReason::Page), 1);
}

TEST_F(EvictionTest, UsefulnessFollowsTheViewAndFallsWhenNobodyLooks) {
    CubeMapUsage usage;
    for (int i = 0; i < 1000; ++i) {
        usage.record(0.25F, /*complete=*/true);
    }
    EXPECT_NEAR(usage.usefulness, 0.25F, 1e-3F);
    EXPECT_EQ(usage.feedbackUnseen, 0);
    EXPECT_EQ(usage.feedbackComplete, 1000);
    float before = usage.usefulness;
    for (int i = 0; i < 1000; ++i) {
        usage.record(0.0F, /*complete=*/false);
        EXPECT_LT(usage.usefulness, before);
        before = usage.usefulness;
    }
    EXPECT_EQ(usage.feedbackUnseen, 1000);
    EXPECT_EQ(usage.feedbackComplete, 1000);
}

TEST_F(EvictionTest, TheBudgetIsCountedInWholeLayers) {
    CubeMapOptions options;
    options.faceSize = 64; // 2 x 2 pages
    constexpr double kLayer = 3 * 64 * 64 + 4 * 4;
    options.memoryBudget = static_cast<float>(10.5 * kLayer / (1024.0 * 1024.0));
    EXPECT_EQ(Eviction::layersWithin(options, 2048), 10);
    EXPECT_EQ(Eviction::layersWithin(options, 8), 8);
    options.memoryBudget = 0.0F;
    EXPECT_EQ(Eviction::layersWithin(options, 2048), 2048);
}

} // namespace
} // namespace aolib
