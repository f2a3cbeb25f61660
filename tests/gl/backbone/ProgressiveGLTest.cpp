// Cube maps computed within a budget, over many frames, and only where a view looks.
#include <set>

#include "ProgressiveTest.h"
#include "WatchedLoader.h"

namespace aolib {
namespace {

class ProgressiveGLTest : public ProgressiveTest {};

/// Whether a cube map knows a pixel's surface: its quality is drawn in plain red where there is but
/// something nearby to guess by, and in grey where there is nothing.
std::vector<bool> knownPixels(SmallHost& host, const Options& options) {
    Options quality = options;
    quality.debugView = DebugView::Quality;
    EXPECT_TRUE(host.ao().setOptions(quality).ok());
    EXPECT_TRUE(host.frame().ok());
    const ByteImage drawn = *host.framebuffer().readColour();
    EXPECT_TRUE(host.ao().setOptions(options).ok());
    EXPECT_TRUE(host.frame().ok());
    std::vector<bool> known;
    for (std::size_t i = 0; i < drawn.pixels.size(); i += 3) {
        const bool guessed = drawn.pixels[i] == 255 && drawn.pixels[i + 1] == 0;
        const bool grey = drawn.pixels[i] == drawn.pixels[i + 2];
        known.push_back(!guessed && !grey);
    }
    return known;
}

TEST_P(ProgressiveGLTest, EndsWhereComputingAtOnceDoes) {
    for (const Estimator estimator : {Estimator::HorizonSplit, Estimator::LayeredIntervals}) {
        Options o = options(estimator);
        o.blur.enabled = false;
        o.cubeMaps.refineStaticViews = false; // which begins with a second frame
        SmallHost slow = hostWith(o);
        ASSERT_TRUE(slow.ao().addCubeMap({0.5F, 3, 5}).ok());
        EXPECT_GT(converge(slow), 2) << "a capture, passes, and 32 frames to come in";
        o.frameBudget = 0.0F;
        SmallHost fast = hostWith(o);
        ASSERT_TRUE(fast.ao().addCubeMap({0.5F, 3, 5}).ok());
        ASSERT_TRUE(fast.frame().ok());
        EXPECT_LE(largestChange(slow.visibility().visibility, fast.visibility().visibility), 0.005);
    }
}

TEST_P(ProgressiveGLTest, NoFrameWaitsNorDoesMoreThanAUnitBeyondItsBudget) {
    for (const Estimator estimator : {Estimator::HorizonSplit, Estimator::LayeredIntervals}) {
        WatchedLoader watched(loader, "a graphics card");
        Options o = options(estimator);
        o.cubeMaps.faceSize = 64;
        o.frameBudget = 1e-6F;
        const Model model = boxOnFloor();
        SmallHost host = hostWith(o, model, watched.loader());
        ASSERT_TRUE(host.ao().addCubeMap({0.5F, 3, 5}).ok());
        int drawn = 0;
        bool converged = false;
        for (int frame = 0; frame < kMostFrames && !converged; ++frame) {
            watched.drawn = 0;
            ASSERT_TRUE(host.frame().ok());
            EXPECT_LE(watched.drawn, static_cast<int>(model.meshes.size())) << "a face at most";
            drawn += watched.drawn;
            converged = host.ao().statistics().converged;
        }
        EXPECT_TRUE(converged);
        EXPECT_GT(drawn, 5) << "this counts nothing";
        EXPECT_EQ(watched.waits, std::vector<std::string>{});
    }
}

TEST_P(ProgressiveGLTest, AGraphicsCardsTimeIsLearnedAndUsed) {
    WatchedLoader watched(loader, "a graphics card");
    Options o = options(Estimator::LayeredIntervals);
    o.frameBudget = 1000.0F;
    SmallHost host = hostWith(o, boxOnFloor(), watched.loader());
    ASSERT_TRUE(host.ao().addCubeMap({0.5F, 3, 5}).ok());
    const int frames = converge(host);
    EXPECT_GT(frames, 0);
    // Over 60 units of capture, and 4 passes of over 20 tiles, in a frame each.
    EXPECT_LT(frames, 100);
    EXPECT_GT(frames, 32 + 6) << "a kind of unknown cost has a frame to itself";
}

TEST_P(ProgressiveGLTest, WhatChangesDuringACaptureIsSeen) {
    for (const Estimator estimator : {Estimator::HorizonSplit, Estimator::LayeredIntervals}) {
        Options o = options(estimator);
        o.frameBudget = 1e-6F;
        Model model = boxOnFloor();
        SmallHost host = hostWith(o, model);
        ASSERT_TRUE(host.ao().addCubeMap({0.5F, 3, 5}).ok());
        for (int frame = 0; frame < 6; ++frame) {
            ASSERT_TRUE(host.frame().ok());
        }
        Model other;
        addBox(other, {2, 0, 0}, {3, 2, 1});
        const ModelMesh& mesh = other.meshes.front();
        ASSERT_TRUE(host.ao().addMesh({mesh.positions, {}, mesh.indices}).ok());
        o.frameBudget = 20.0F;
        ASSERT_TRUE(host.ao().setOptions(o).ok());
        ASSERT_GT(converge(host), 0);
        addBox(model, {2, 0, 0}, {3, 2, 1});
        o.frameBudget = 0.0F;
        SmallHost whole = hostWith(o, model);
        ASSERT_TRUE(whole.ao().addCubeMap({0.5F, 3, 5}).ok());
        const auto cube = [](SmallHost& of) {
            return *of.ao().readCubeMap(of.ao().cubeMaps().front().id);
        };
        const CubeMapImage slow = cube(host);
        const CubeMapImage fast = cube(whole);
        const std::size_t at = texelTowards(fast, {2.5F, 2, 0.8F});
        EXPECT_NEAR(slow.distance[at], fast.distance[at], 0.01F) << "the top of the box";
    }
}

TEST_P(ProgressiveGLTest, TheFirstPictureIsCloseToTheLastAndTheLastStays) {
    for (const Estimator estimator : {Estimator::LayeredIntervals, Estimator::RayTraced}) {
        SmallHost host = hostWith(options(estimator));
        ASSERT_TRUE(host.ao().addCubeMap({0.5F, 3, 5}).ok());
        int frame = 0;
        while (host.ao().statistics().cubeMapsProjected == 0 && ++frame < kMostFrames) {
            ASSERT_TRUE(host.frame().ok());
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        const Picture first = host.visibility().visibility;
        ASSERT_GT(converge(host), 0);
        const Picture last = host.visibility().visibility;
        EXPECT_LE(rmse(first, last), 0.06);
        for (int i = 0; i < 5; ++i) {
            ASSERT_TRUE(host.frame().ok());
            EXPECT_EQ(host.visibility().visibility, last) << "a converged picture stays as it is";
            EXPECT_TRUE(host.ao().statistics().converged);
        }
    }
}

TEST_P(ProgressiveGLTest, OnlyWhatAViewShowsIsComputed) {
    for (const Estimator estimator : {Estimator::LayeredIntervals, Estimator::RayTraced}) {
        SmallHost host = hostWith(options(estimator));
        const CubeMapId id = *host.ao().addCubeMap({0.5F, 3, 5});
        ASSERT_GT(converge(host), 0);
        const auto known = [&] {
            const CubeMapImage cube = *host.ao().readCubeMap(id);
            return std::count_if(cube.distance.begin(), cube.distance.end(),
                                 [](float distance) { return distance > 0.0F; });
        };
        const auto before = known();
        EXPECT_GE(host.ao().statistics().coverage, 0.99F);
        host.lookAt({0.5F, 3, 5}, {6, 0, 5});
        ASSERT_TRUE(host.frame().ok());
        gl.Finish();
        ASSERT_TRUE(host.frame().ok()); // the survey of the turned view has arrived
        EXPECT_FALSE(host.ao().statistics().converged);
        ASSERT_GT(converge(host), 0);
        EXPECT_GT(known(), before + before / 10) << "another view asks for other tiles";
        EXPECT_GE(host.ao().statistics().coverage, 0.99F);
    }
}

TEST_P(ProgressiveGLTest, AViewIsSurveyedAsOftenAsItChanges) {
    SmallHost host = hostWith(options(Estimator::LayeredIntervals));
    ASSERT_TRUE(host.ao().addCubeMap({0.5F, 3, 5}).ok());
    ASSERT_GT(converge(host), 0);
    const auto surveysIn = [&](int frames) {
        std::set<std::uint64_t> hasFeedback{host.ao().statistics().coverageFrame};
        for (int i = 0; i < frames; ++i) {
            EXPECT_TRUE(host.frame().ok());
            gl.Finish();
            hasFeedback.insert(host.ao().statistics().coverageFrame);
        }
        return hasFeedback.size() - 1;
    };
    surveysIn(8); // those that were on their way
    const std::size_t atRest = surveysIn(32);
    EXPECT_GE(atRest, 3U) << "the host may draw what it has not described";
    EXPECT_LE(atRest, 5U);
    std::size_t moving = 0;
    for (int i = 0; i < 24; ++i) {
        host.lookAt({0.5F, 3, 5}, {0.1F * static_cast<float>(i), 0.5F, 0});
        moving += surveysIn(1);
    }
    EXPECT_GE(moving, 7U) << "every third frame's, a frame or two later";
    EXPECT_LE(moving, 10U);
}

TEST_P(ProgressiveGLTest, ANewCubeMapComesInWithoutAStep) {
    Options o = options(Estimator::RayTraced);
    o.rayTraced.rays = 64;
    o.cubeMaps.refineStaticViews = false;
    SmallHost host = hostWith(o);
    ASSERT_TRUE(host.ao().addCubeMap({-3, 4, 3}).ok());
    ASSERT_GT(converge(host), 0);
    const std::vector<bool> known = knownPixels(host, o);
    ASSERT_GT(std::ranges::count(known, true), std::ranges::count(known, false)); // and background
    Picture before = host.visibility().visibility;
    ASSERT_TRUE(host.ao().addCubeMap({0.5F, 3, 5}).ok());
    const auto largestChangeOfKnown = [&known](const Picture& a, const Picture& b) {
        double largest = 0.0; // what no cube map knew before appears at once
        for (std::size_t i = 0; i < a.size(); ++i) {
            const double change = std::abs(static_cast<double>(b[i] - a[i]));
            largest = known[i] ? std::max(largest, change) : largest;
        }
        return largest;
    };
    const Picture old = before;
    double largest = 0.0;
    for (int frame = 0; frame < kMostFrames; ++frame) {
        ASSERT_TRUE(host.frame().ok());
        gl.Finish();
        const Picture now = host.visibility().visibility;
        largest = std::max(largest, largestChangeOfKnown(before, now));
        before = now;
        if (host.ao().statistics().converged) {
            break;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    ASSERT_TRUE(host.ao().statistics().converged);
    const double whole = largestChangeOfKnown(old, before);
    EXPECT_GT(whole, 0.05) << "the two know edges differently; else this shows nothing";
    EXPECT_LT(largest, 0.55 * whole) << "of which no frame shows more than a part";
    EXPECT_LT(largest, 0.06);
}

AOLIB_FOR_ALL_CONTEXTS(ProgressiveGLTest);

} // namespace
} // namespace aolib
