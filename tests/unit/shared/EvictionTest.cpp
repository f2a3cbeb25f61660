#include "backbone/cubemapped/Eviction.h"

#include <gtest/gtest.h>

namespace aolib {
namespace {

/// Cube maps that have been complete for long, the first the most useful.
class EvictionTest : public testing::Test {
protected:
    EvictionTest() {
        for (const float usefulness : {0.8F, 0.1F, 0.01F}) {
            cubeMaps_.push_back(std::make_unique<CubeMapProjector>());
            use(cubeMaps_.size() - 1) = {.usefulness = usefulness, .surveysComplete = 1000};
        }
    }

    CubeMapProjector::Use& use(std::size_t i) { return cubeMaps_[i]->use; }
    /// The number of the victim, all of them being in use; -1 for none.
    int victim(Eviction::For reason = Eviction::For::Newcomer, bool inUse = true) const {
        std::vector<CubeMapProjector*> used;
        for (const auto& one : cubeMaps_) {
            used.push_back(one.get());
        }
        const CubeMapProjector* found =
            Eviction::victim(cubeMaps_, inUse ? used : std::vector<CubeMapProjector*>(), reason);
        for (std::size_t i = 0; i < cubeMaps_.size(); ++i) {
            if (cubeMaps_[i].get() == found) {
                return static_cast<int>(i);
            }
        }
        return -1;
    }

    std::vector<std::unique_ptr<CubeMapProjector>> cubeMaps_;
};

TEST_F(EvictionTest, TheLeastUsefulGoesFirst) {
    EXPECT_EQ(victim(), 2);
    use(2).usefulness = 0.5F;
    EXPECT_EQ(victim(), 1);
}

TEST_F(EvictionTest, ThoseByHandStayUnlessTheBudgetShrinks) {
    use(2).byHand = true;
    EXPECT_EQ(victim(), 1);
    use(0).byHand = use(1).byHand = true;
    EXPECT_EQ(victim(), -1);
    use(0).byHand = false;
    EXPECT_EQ(victim(Eviction::For::Budget), 0) << "those by hand last";
    use(0).byHand = true;
    EXPECT_EQ(victim(Eviction::For::Budget), 2);
}

TEST_F(EvictionTest, WhatWasJustComputedIsShownFirst) {
    use(2).surveysComplete = 3;
    EXPECT_EQ(victim(), 1);
    use(0).surveysComplete = use(1).surveysComplete = 3;
    EXPECT_EQ(victim(), -1);
    EXPECT_EQ(victim(Eviction::For::Newcomer, /*inUse=*/false), 2) << "it is shown nowhere";
}

TEST_F(EvictionTest, OneThatGoesAlreadyIsTheOne) {
    use(0).retiring = true;
    EXPECT_EQ(victim(), 0);
}

TEST_F(EvictionTest, DetailPushesOutOnlyWhatNobodySees) {
    EXPECT_EQ(victim(Eviction::For::Block), -1);
    use(1).surveysUnseen = 1000;
    EXPECT_EQ(victim(Eviction::For::Block), 1);
}

TEST_F(EvictionTest, UsefulnessFollowsTheViewAndFallsWhenNobodyLooks) {
    cubeMaps_.resize(1);
    use(0) = {};
    cubeMaps_[0]->bias = 0.0F;
    const CubeMapId id = cubeMaps_[0]->id();
    for (int i = 0; i < 1000; ++i) {
        Eviction::follow(cubeMaps_, {{id, 0.25F}});
    }
    EXPECT_NEAR(use(0).usefulness, 0.25F, 1e-3F);
    EXPECT_EQ(use(0).surveysUnseen, 0);
    EXPECT_EQ(use(0).surveysComplete, 1000);
    float before = use(0).usefulness;
    for (int i = 0; i < 1000; ++i) {
        Eviction::follow(cubeMaps_, {});
        EXPECT_LT(use(0).usefulness, before);
        before = use(0).usefulness;
    }
    EXPECT_EQ(use(0).surveysUnseen, 1000);
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
