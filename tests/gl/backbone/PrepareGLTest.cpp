// Progress: cube maps computed behind a loading screen, and how much of a picture is computed.
#include <stdexcept>

#include "ProgressiveTest.h"

namespace aolib {

namespace {

constexpr std::array kEstimators{Estimator::HorizonSplit, Estimator::LayeredIntervals,
                                 Estimator::RayTraced};

class PrepareGLTest : public ProgressiveTest {};

TEST_P(PrepareGLTest, ComputesAllWithProgressThatOnlyGrows) {
    for (const Estimator estimator : kEstimators) {
        for (const float budget : {0.0F, 4.0F}) {
            SCOPED_TRACE(static_cast<int>(estimator));
            Options o = options(estimator);
            o.frameBudget = budget;
            SmallHost host = hostWith(o);
            float before = 0.0F;
            const std::vector<glm::vec3> places{{0.5F, 3, 5}, {-2, 2, 2}};
            const auto callback = [&](float progress) {
                EXPECT_GE(progress, before);
                EXPECT_LE(progress, 1.0F);
                before = progress;
                EXPECT_EQ(host.ao().clear().code(), StatusCode::InvalidCallOrder);
                return true;
            };
            ASSERT_TRUE(host.ao().prepare(callback, places).ok());
            EXPECT_EQ(before, 1.0F);
            ASSERT_EQ(host.ao().cubeMaps().size(), 2U);
            for (const CubeMapInfo& info : host.ao().cubeMaps()) {
                EXPECT_GT(info.buildMs, 0.0);
                EXPECT_GT(info.facesModelled, 0);
            }
            ASSERT_TRUE(host.ao().prepare({}, places).ok());
            EXPECT_EQ(host.ao().cubeMaps().size(), 2U) << "they stand there";
            ASSERT_TRUE(host.frame().ok());
            EXPECT_EQ(host.ao().statistics().cubeMapsBuilt, 0);
            EXPECT_EQ(host.ao().statistics().cubeMapsProjected, 2);
            EXPECT_LT(host.visibilityAt({0.7F, 0, 0.7F}), 0.95F);
        }
    }
}

TEST_P(PrepareGLTest, MayBeStoppedAndGoneOnWith) {
    SmallHost host = hostWith(options(Estimator::RayTraced));
    int calls = 0;
    EXPECT_EQ(host.ao()
                  .prepare([&](float) { return ++calls < 2; }, std::array{glm::vec3(0, 3, 5)})
                  .code(),
              StatusCode::Cancelled);
    EXPECT_EQ(calls, 2);
    ASSERT_EQ(host.ao().cubeMaps().size(), 1U);
    float first = -1.0F;
    ASSERT_TRUE(host.ao()
                    .prepare([&](float progress) {
                        first = first < 0.0F ? progress : first;
                        return true;
                    })
                    .ok());
    EXPECT_GT(first, 0.0F) << "what was computed has stayed";
}

TEST_P(PrepareGLTest, RefusesWhatItCannotDo) {
    SmallHost host = hostWith(options(Estimator::RayTraced));
    const auto thrower = [](float) -> bool { throw std::runtime_error("as agreed"); };
    EXPECT_EQ(host.ao().prepare(thrower, std::array{glm::vec3(0, 3, 5)}).code(),
              StatusCode::CallbackFailed);
    const glm::vec3 nowhere(std::nanf(""), 0, 0);
    EXPECT_EQ(host.ao().prepare({}, std::array{nowhere}).code(), StatusCode::InvalidPosition);
    ASSERT_TRUE(host.ao().aoDrawBegin().ok());
    EXPECT_EQ(host.ao().prepare({}).code(), StatusCode::InvalidCallOrder);
    ASSERT_TRUE(host.frame().code() == StatusCode::InvalidCallOrder);
    SmallHost empty = hostWith(options(Estimator::HorizonSplit), Model());
    EXPECT_EQ(empty.ao().prepare({}).code(), StatusCode::NoScene);
}

TEST_P(PrepareGLTest, WhatAPictureLacksOnlyShrinks) {
    for (const Estimator estimator : kEstimators) {
        SCOPED_TRACE(static_cast<int>(estimator));
        Options o = options(estimator);
        o.frameBudget = 2.0F;
        o.cubeMaps.place = true;
        SmallHost host = hostWith(o);
        EXPECT_EQ(host.ao().statistics().computed, 0.0F) << "nothing is known yet";
        float before = 0.0F;
        bool between = false;
        for (int i = 0; i < kMostFrames && before < 1.0F; ++i) {
            ASSERT_TRUE(host.frame().ok());
            gl.Finish();
            const Statistics statistics = host.ao().statistics();
            EXPECT_EQ(i == 0, i == 0 && statistics.computed == 0.0F);
            ASSERT_GE(statistics.computed, before) << "frame " << i;
            ASSERT_EQ(statistics.computed == 1.0F, statistics.converged);
            before = statistics.computed;
            between = between || (before > 0.0F && before < 1.0F);
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        EXPECT_EQ(before, 1.0F);
        EXPECT_TRUE(between);
    }
}

TEST_P(PrepareGLTest, ABuildInOneCallHasItsTime) {
    for (const Estimator estimator : kEstimators) {
        Options o = options(estimator);
        o.frameBudget = 0.0F;
        SmallHost host = hostWith(o);
        ASSERT_TRUE(host.ao().addCubeMap({0.5F, 3, 5}).ok());
        EXPECT_GT(host.ao().cubeMaps().front().buildMs, 0.0) << static_cast<int>(estimator);
    }
}

INSTANTIATE_TEST_SUITE_P(One, PrepareGLTest, testing::Values(testContexts().front()), nameOf);

} // namespace

} // namespace aolib
