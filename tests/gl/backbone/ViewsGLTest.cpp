// Several views on one instance: split screen, four views of a CAD program.
#include <array>
#include <functional>
#include <utility>

#include "ProgressiveTest.h"

namespace aolib {

namespace {

constexpr ViewId kAbove{7};
constexpr ViewId kFront{8};
constexpr ViewId kAslant{9};

class ViewsGLTest : public ProgressiveTest {
protected:
    static constexpr std::array<ViewId, 3> kAll{kAbove, kFront, kAslant};

    static Options viewOptions(Estimator estimator) {
        Options o = options(estimator);
        o.cubeMaps.place = true;
        return o;
    }
    static void look(SmallHost& host, ViewId view) {
        if (view == kAbove) {
            host.lookAcross({0.2F, 30, 0}, {0.2F, 0, 0}, {0, 0, -1}, 3.0F);
        } else if (view == kFront) {
            host.lookAcross({0, 0.5F, 30}, {0, 0.5F, 0}, {0, 1, 0}, 3.0F);
        } else {
            host.lookAt({2, 3, 4}, {0, 0.5F, 0});
        }
    }
    AoStatus draw(SmallHost& host, ViewId view, bool named = true) {
        look(host, view);
        const AoStatus status = host.frame(named ? view : ViewId{});
        gl.Finish();
        return status;
    }
    /// Draws the views by turns until nothing is left to compute for any. @return rounds; -1: never
    int convergeAll(SmallHost& host, bool named = true) {
        for (int round = 0; round < kMostFrames; ++round) {
            for (const ViewId view : kAll) {
                EXPECT_TRUE(draw(host, view, named).ok());
            }
            if (host.ao().statistics().allConverged) {
                return round;
            }
            std::this_thread::sleep_for(std::chrono::milliseconds(1)); // for the tracer's worker
        }
        return -1;
    }
    /// What an instance of its own makes of a view.
    Picture alone(ViewId view, const Options& o) {
        SmallHost host = hostWith(o);
        for (int i = 0; i < kMostFrames; ++i) {
            EXPECT_TRUE(draw(host, view).ok());
            if (host.ao().statistics(view).converged) {
                return host.visibility().visibility;
            }
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        ADD_FAILURE() << "never converged";
        return {};
    }
};

TEST_P(ViewsGLTest, AllConvergeToWhatEachWouldBeAlone) {
    for (const Estimator estimator : {Estimator::RayTraced, Estimator::LayeredIntervals}) {
        SCOPED_TRACE(static_cast<int>(estimator));
        SmallHost host = hostWith(viewOptions(estimator));
        ASSERT_GE(convergeAll(host), 0);
        for (const ViewId view : kAll) {
            const Statistics statistics = host.ao().statistics(view);
            EXPECT_TRUE(statistics.converged);
            EXPECT_EQ(statistics.computed, 1.0F);
            EXPECT_GT(statistics.pixelsRefined, 0U);
            const Picture picture = host.ao().readVisibility(view)->visibility;
            EXPECT_LT(rmse(picture, alone(view, viewOptions(estimator))), 0.02);
            ASSERT_TRUE(draw(host, view).ok());
            EXPECT_EQ(host.visibility().visibility, picture) << "it stays";
        }
        EXPECT_EQ(host.ao().statistics().views, 3);
    }
}

TEST_P(ViewsGLTest, CamerasThatTakeTurnsWithoutNamesConvergeToo) {
    SmallHost host = hostWith(viewOptions(Estimator::RayTraced));
    EXPECT_GE(convergeAll(host, /*named=*/false), 0);
    EXPECT_EQ(host.ao().statistics().views, 3);
    EXPECT_GT(host.ao().statistics().pixelsRefined, 0U);
}

TEST_P(ViewsGLTest, OneThatMovesDoesNotKeepAnotherFromConverging) {
    Options o = viewOptions(Estimator::RayTraced);
    o.cubeMaps.faceSize = 64;
    SmallHost host = hostWith(o);
    bool converged = false;
    for (int i = 0; i < kMostFrames && !converged; ++i) {
        ASSERT_TRUE(draw(host, kAbove).ok());
        converged = host.ao().statistics(kAbove).converged;
        const float turn = 0.05F * static_cast<float>(i);
        host.lookAt({3 * std::cos(turn), 2.5F, 3 * std::sin(turn)}, {0, 0.5F, 0});
        ASSERT_TRUE(host.frame(kAslant).ok());
        EXPECT_FALSE(host.ao().statistics().converged) << "it moves";
        EXPECT_FALSE(host.ao().statistics().allConverged);
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    EXPECT_TRUE(converged);
}

TEST_P(ViewsGLTest, ViewsComeAndGo) {
    SmallHost host = hostWith(viewOptions(Estimator::LayeredIntervals));
    EXPECT_FALSE(host.ao().statistics(kFront).converged) << "nobody has drawn it";
    EXPECT_EQ(host.ao().readVisibility(kFront).status().code(), StatusCode::InvalidCallOrder);
    ASSERT_TRUE(draw(host, kAbove).ok());
    const std::size_t one = host.ao().statistics().bytesFrame;
    ASSERT_TRUE(draw(host, kFront).ok());
    EXPECT_FALSE(host.ao().statistics().allConverged);
    EXPECT_GT(host.ao().statistics().bytesFrame, one);
    ASSERT_TRUE(host.ao().removeView(kFront).ok());
    EXPECT_EQ(host.ao().statistics().views, 1);
    EXPECT_EQ(host.ao().statistics().bytesFrame, one);
    EXPECT_EQ(host.ao().readVisibility().status().code(), StatusCode::InvalidCallOrder)
        << "the latest frame was its";
    ASSERT_TRUE(host.ao().removeView(kFront).ok());
    ASSERT_TRUE(draw(host, kFront).ok());
    EXPECT_EQ(host.ao().readVisibility()->width, 160);
}

TEST_P(ViewsGLTest, AViewThatNobodyDrawsStopsToCostMemory) {
    Options o = viewOptions(Estimator::HorizonSplit);
    o.cubeMaps.faceSize = 32;
    SmallHost host = hostWith(o);
    ASSERT_TRUE(draw(host, kAbove).ok());
    const std::size_t one = host.ao().statistics().bytesFrame;
    ASSERT_TRUE(draw(host, kFront).ok());
    for (int i = 0; i < 300; ++i) {
        ASSERT_TRUE(draw(host, kAbove).ok());
    }
    EXPECT_EQ(host.ao().statistics().views, 1);
    EXPECT_EQ(host.ao().statistics().bytesFrame, one);
}

TEST_P(ViewsGLTest, SaysWhatAFrameWithoutGeometryLacks) {
    SmallHost host = hostWith(viewOptions(Estimator::HorizonSplit));
    for (int i = 0; i < 8; ++i) {
        ASSERT_TRUE(draw(host, kAslant).ok());
        host.lookAt({2, 3, 4}, {2, 9, 4.1F}); // nothing but sky
        ASSERT_TRUE(host.frame(kAbove).ok());
        gl.Finish();
    }
    EXPECT_GT(host.ao().statistics(kAslant).geometryShare, 0.1F);
    EXPECT_EQ(host.ao().statistics(kAbove).geometryShare, 0.0F);
}

TEST_P(ViewsGLTest, WhereAnOrthographicEyeStandsDoesNotMatter) {
    Options o = viewOptions(Estimator::RayTraced);
    o.cubeMaps.refineStaticViews = false;
    std::vector<Picture> pictures;
    for (const float height : {2.0F, 30.0F, 600.0F}) {
        SmallHost host = hostWith(o);
        host.lookAcross({0.2F, height, 0}, {0.2F, height - 1, 0}, {0, 0, -1}, 3.0F);
        ASSERT_GT(converge(host), 0);
        EXPECT_GT(host.ao().statistics().coverage, 0.9F);
        pictures.push_back(host.visibility().visibility);
        EXPECT_LT(rmse(pictures.back(), pictures.front()), 0.005) << height;
    }
}

TEST_P(ViewsGLTest, TexelsThatAreLongerThanTheReachOfOccludersKnowNothing) {
    SmallHost host = hostWith(options(Estimator::LayeredIntervals));
    ASSERT_TRUE(host.ao().addCubeMap({30, 1, 0}).ok()); // along the floor
    look(host, kAbove);
    ASSERT_GT(converge(host), 0);
    EXPECT_LT(host.ao().statistics().coverage, 0.5F);
}

INSTANTIATE_TEST_SUITE_P(One, ViewsGLTest, testing::Values(testContexts().front()), nameOf);

} // namespace

} // namespace aolib
