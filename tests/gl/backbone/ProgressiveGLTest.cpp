// Cube maps computed within a budget, over many frames, and only where a view looks.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

#include <aolib/RayTracing.h>

#include "SmallScene.h"
#include "WatchedLoader.h"

namespace aolib {
namespace {

using Picture = std::vector<float>;

class ProgressiveGLTest : public GLTest {
protected:
    static constexpr int kMostFrames = 4000;

    static Options options(Estimator estimator) {
        Options o;
        o.estimator = estimator;
        o.radius = 1.5F;
        o.frameBudget = 20.0F;
        o.cubeMaps.faceSize = 128;
        o.cubeMaps.place = false;
        o.layeredIntervals = {.slices = 4, .steps = 8};
        o.rayTraced.rays = 256;
        return o;
    }

    SmallHost hostWith(const Options& o, const Model& model = boxOnFloor()) {
        return hostWith(o, model, loader);
    }
    SmallHost hostWith(const Options& o, const Model& model, const ProcAddressLoader& through) {
        SmallHost host(gl, through, model, o);
        auto tracer = createTexelTracer(1);
        EXPECT_TRUE(tracer.ok()) << tracer.status().message();
        host.ao().setTexelTracer(std::move(*tracer));
        host.lookAt({0.5F, 3, 5}, {0, 0.5F, 0});
        return host;
    }

    /// Draws until all is computed. @return frames it took; -1 when it never ended.
    int converge(SmallHost& host) {
        for (int frame = 1; frame <= kMostFrames; ++frame) {
            const Status status = host.frame();
            EXPECT_TRUE(status.ok()) << status.message();
            gl.Finish();
            if (!status || host.ao().statistics().converged) {
                return status ? frame : -1;
            }
            std::this_thread::sleep_for(std::chrono::milliseconds(1)); // for the tracer's worker
        }
        return -1;
    }

    static double rmse(const Picture& a, const Picture& b) {
        double sum = 0.0;
        std::size_t count = 0;
        for (std::size_t i = 0; i < a.size(); ++i) {
            if (a[i] >= 0.0F) {
                sum += std::pow(static_cast<double>(a[i] - b[i]), 2);
                ++count;
            }
        }
        return std::sqrt(sum / static_cast<double>(count));
    }

    static double largestChange(const Picture& a, const Picture& b) {
        double largest = 0.0;
        for (std::size_t i = 0; i < a.size(); ++i) {
            largest = std::max(largest, std::abs(static_cast<double>(a[i] - b[i])));
        }
        return largest;
    }
};

TEST_P(ProgressiveGLTest, EndsWhereComputingAtOnceDoes) {
    for (const Estimator estimator : {Estimator::HorizonSplit, Estimator::LayeredIntervals}) {
        Options o = options(estimator);
        o.blur.enabled = false;
        o.rayTraced.repair = false; // which begins with a second frame
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

TEST_P(ProgressiveGLTest, ANewCubeMapComesInWithoutAStep) {
    Options o = options(Estimator::RayTraced);
    o.rayTraced = {.rays = 64, .repair = false};
    SmallHost host = hostWith(o);
    ASSERT_TRUE(host.ao().addCubeMap({-3, 4, 3}).ok());
    ASSERT_GT(converge(host), 0);
    Picture before = host.visibility().visibility;
    ASSERT_TRUE(host.ao().addCubeMap({0.5F, 3, 5}).ok());
    const Picture old = before;
    double largest = 0.0;
    for (int frame = 0; frame < kMostFrames; ++frame) {
        ASSERT_TRUE(host.frame().ok());
        gl.Finish();
        const Picture now = host.visibility().visibility;
        for (std::size_t i = 0; i < now.size(); ++i) {
            // What no cube map knew before appears at once.
            if (old[i] < 1.0F && old[i] >= 0.0F) {
                largest = std::max(largest, std::abs(static_cast<double>(now[i] - before[i])));
            }
        }
        before = now;
        if (host.ao().statistics().converged) {
            break;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    ASSERT_TRUE(host.ao().statistics().converged);
    const double whole = largestChange(old, before);
    EXPECT_GT(whole, 0.05) << "the two know edges differently; else this shows nothing";
    EXPECT_LT(largest, 0.35 * whole) << "of which no frame shows more than a part";
}

TEST_P(ProgressiveGLTest, TracedTexelsFollowTheClosedForm) {
    Model model;
    addQuad(model, {0, 0, -60}, {0, 0, 60}, {60, 0, 60}, {60, 0, -60});
    addQuad(model, {0, 0, -60}, {0, 2, -60}, {0, 2, 60}, {0, 0, 60});
    Options o = options(Estimator::RayTraced);
    o.falloff = Falloff::None;
    o.frameBudget = 0.0F;
    o.rayTraced.rays = 1024;
    SmallHost host = hostWith(o, model);
    const auto id = host.ao().addCubeMap({1.5F, 3.0F, 0.1F});
    ASSERT_TRUE(id.ok()) << id.status().message();
    const CubeMapImage cube = *host.ao().readCubeMap(*id);
    for (const float d : {0.5F, 1.0F, 2.0F}) {
        // A wall of height h, endless, at distance d: W = (1 + d / sqrt(d^2 + h^2)) / 2.
        const float expected = 0.5F * (1.0F + d / std::sqrt(d * d + 4.0F));
        EXPECT_NEAR(cube.visibility[texelTowards(cube, {d, 0, 0})], expected, 0.02F);
    }
}

TEST_P(ProgressiveGLTest, WhatIsTracedTwiceCountsOnce) {
    Options o = options(Estimator::RayTraced);
    o.rayTraced = {.rays = 16, .repair = false}; // one pass
    SmallHost host = hostWith(o);
    ASSERT_TRUE(host.ao().addCubeMap({0.5F, 3, 5}).ok());
    for (int frame = 0; frame < 200; ++frame) {
        // Each view asks for more, so that what is asked of the tracer changes while it works.
        const float angle = 0.05F * static_cast<float>(frame);
        host.lookAt({0.5F, 3, 5}, {0.5F + std::sin(angle), 2.5F, 5 - std::cos(angle)});
        ASSERT_TRUE(host.frame().ok());
        ASSERT_LE(host.ao().statistics().computed, 1.0F) << "frame " << frame;
    }
}

TEST_P(ProgressiveGLTest, TracedTexelsFollowTheScene) {
    Model floor;
    addQuad(floor, {-8, 0, -8}, {-8, 0, 8}, {8, 0, 8}, {8, 0, -8});
    SmallHost host = hostWith(options(Estimator::RayTraced), floor);
    ASSERT_TRUE(host.ao().addCubeMap({0.5F, 3, 5}).ok());
    ASSERT_GT(converge(host), 0);
    EXPECT_EQ(host.visibilityAt({0, 0, 1.3F}), 1.0F);
    Model box;
    addBox(box, {-1, 0, -1}, {1, 2, 1});
    const ModelMesh& mesh = box.meshes.front();
    const auto id =
        host.ao().addMesh({.positions = mesh.positions, .normals = {}, .indices = mesh.indices});
    ASSERT_TRUE(id.ok()) << id.status().message();
    ASSERT_GT(converge(host), 0);
    EXPECT_LT(host.visibilityAt({0, 0, 1.3F}), 0.8F) << "the box darkens the floor before it";
    ASSERT_TRUE(host.ao().removeMesh(*id).ok());
    ASSERT_GT(converge(host), 0);
    EXPECT_EQ(host.visibilityAt({0, 0, 1.3F}), 1.0F);
}

/// A fence: bars that are narrower than a texel and at times than a pixel.
Model fence() {
    Model model;
    addQuad(model, {-8, 0, -8}, {-8, 0, 8}, {8, 0, 8}, {8, 0, -8});
    for (int i = 0; i < 40; ++i) {
        const float x = -4.0F + 0.2F * static_cast<float>(i);
        addBox(model, {x, 0, -0.02F}, {x + 0.05F, 1.5F, 0.02F});
    }
    return model;
}

TEST_P(ProgressiveGLTest, LayeredIntervalsAreRepairedWhereThereIsATracer) {
    Options o = options(Estimator::LayeredIntervals);
    SmallHost traced = hostWith(options(Estimator::RayTraced), fence());
    SmallHost layered = hostWith(o, fence());
    o.rayTraced.repair = false;
    SmallHost plain = hostWith(o, fence());
    for (SmallHost* host : {&traced, &layered, &plain}) {
        ASSERT_TRUE(host->ao().addCubeMap({0.5F, 3, 5}).ok());
        ASSERT_GT(converge(*host), 0);
    }
    EXPECT_GT(layered.ao().statistics().pixelsTraced, 500U);
    EXPECT_EQ(plain.ao().statistics().pixelsTraced, 0U);
    const Picture truth = traced.visibility().visibility;
    EXPECT_LT(rmse(layered.visibility().visibility, truth),
              0.7 * rmse(plain.visibility().visibility, truth));
    // A radius makes another question of it.
    o.rayTraced.repair = true;
    o.radius = 0.1F;
    ASSERT_TRUE(layered.ao().setOptions(o).ok());
    ASSERT_TRUE(layered.frame().ok());
    EXPECT_EQ(layered.ao().statistics().pixelsTraced, 0U);
    ASSERT_GT(converge(layered), 0);
    EXPECT_GT(rmse(layered.visibility().visibility, truth), 0.05);
}

TEST_P(ProgressiveGLTest, RepairLastsUntilTheViewMovesAndComesBack) {
    Options o = options(Estimator::RayTraced);
    o.frameBudget = 0.0F;
    SmallHost host = hostWith(o, fence());
    ASSERT_TRUE(host.ao().addCubeMap({0.5F, 3, 5}).ok());
    ASSERT_GT(converge(host), 0);
    host.lookAt({0.6F, 3, 5}, {0, 0.5F, 0});
    ASSERT_GT(converge(host), 0); // what both views ask of the cube map is there
    host.lookAt({0.5F, 3, 5}, {0, 0.5F, 0});
    ASSERT_TRUE(host.frame().ok());
    EXPECT_FALSE(host.ao().statistics().converged) << "a view that was seen once may be moving";
    const Picture moving = host.visibility().visibility;
    ASSERT_TRUE(host.frame().ok());
    EXPECT_TRUE(host.ao().statistics().converged);
    const Picture resting = host.visibility().visibility;
    EXPECT_GT(largestChange(moving, resting), 0.05);
    host.lookAt({0.6F, 3, 5}, {0, 0.5F, 0});
    ASSERT_TRUE(host.frame().ok());
    EXPECT_EQ(host.ao().statistics().pixelsTraced, 0U);
    host.lookAt({0.5F, 3, 5}, {0, 0.5F, 0});
    ASSERT_TRUE(host.frame().ok());
    EXPECT_EQ(host.visibility().visibility, moving);
    ASSERT_TRUE(host.frame().ok());
    EXPECT_EQ(host.visibility().visibility, resting);
}

TEST_P(ProgressiveGLTest, RepairStaysWhenCubeMapsComeAndGo) {
    SmallHost host = hostWith(options(Estimator::RayTraced), fence());
    const CubeMapId first = *host.ao().addCubeMap({0.5F, 3, 5});
    ASSERT_GT(converge(host), 0);
    const Picture before = host.visibility().visibility;
    ASSERT_TRUE(host.ao().addCubeMap({-2, 2, 4}).ok());
    ASSERT_TRUE(host.frame().ok());
    EXPECT_EQ(host.visibility().visibility, before) << "it is not shown yet";
    EXPECT_FALSE(host.ao().statistics().converged);
    ASSERT_GT(converge(host), 0);
    EXPECT_LT(rmse(host.visibility().visibility, before), 0.01);
    ASSERT_TRUE(host.ao().removeCubeMap(first).ok());
    ASSERT_GT(converge(host), 0);
    EXPECT_LT(rmse(host.visibility().visibility, before), 0.02)
        << "what only the first knew is traced";
}

/// What the host draws without describing it hides what was traced for its pixels, and is not
/// traced itself.
TEST_P(ProgressiveGLTest, RepairHoldsForTheDepthThatItWasTracedFor) {
    Options o = options(Estimator::RayTraced);
    o.frameBudget = 0.0F;
    SmallHost host = hostWith(o, fence());
    ASSERT_TRUE(host.ao().addCubeMap({0.5F, 3, 5}).ok());
    ASSERT_GT(converge(host), 0);
    const Picture before = host.visibility().visibility;
    Model intruder = fence();
    addBox(intruder, {-8, 0.1F, 1}, {8, 0.6F, 2});
    auto other = host::HostRenderer::create(gl, intruder);
    ASSERT_TRUE(other.ok());
    std::swap(host.renderer(), *other);
    ASSERT_TRUE(host.frame().ok());
    const Picture during = host.visibility().visibility;
    std::swap(host.renderer(), *other);
    ASSERT_TRUE(host.frame().ok());
    EXPECT_EQ(host.visibility().visibility, before) << "the pixels are what they were";
    EXPECT_GT(largestChange(during, before), 0.1);
    o.rayTraced.repair = false;
    ASSERT_TRUE(host.ao().setOptions(o).ok());
    std::swap(host.renderer(), *other);
    ASSERT_TRUE(host.frame().ok());
    const Picture plain = host.visibility().visibility;
    std::size_t own = 0; // pixels of the intruder, as wherever nothing was traced
    for (std::size_t i = 0; i < plain.size(); ++i) {
        own += during[i] == plain[i] ? 1U : 0U;
    }
    EXPECT_GT(own, plain.size() / 2);
}

TEST_P(ProgressiveGLTest, WithoutATracerTheFrameSaysSo) {
    SmallHost host(gl, loader, boxOnFloor(), options(Estimator::RayTraced));
    host.lookAt({0.5F, 3, 5}, {0, 0.5F, 0});
    ASSERT_TRUE(host.ao().addCubeMap({0.5F, 3, 5}).ok()) << "its turn comes in a frame";
    const Status status = host.frame();
    EXPECT_EQ(status.code(), StatusCode::MissingCapability);
    EXPECT_NE(status.message().find("setTexelTracer"), std::string::npos) << status.message();
    host.ao().setTexelTracer(std::move(*createTexelTracer(1)));
    EXPECT_GT(converge(host), 0);
    Options screen = options(Estimator::RayTraced);
    screen.backbone = Backbone::ScreenSpace;
    EXPECT_EQ(host.ao().setOptions(screen).code(), StatusCode::InvalidOption);
}

AOLIB_FOR_ALL_CONTEXTS(ProgressiveGLTest);

} // namespace
} // namespace aolib
