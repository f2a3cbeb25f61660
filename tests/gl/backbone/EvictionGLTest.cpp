// Cube maps give way to newer ones where the memory budget has no room for all.
#include <chrono>
#include <set>
#include <thread>

#include <aolib/RayTracing.h>

#include "GlObjects.h"
#include "Rooms.h"
#include "SmallScene.h"
#include "backbone/cubemaps/FaceStore.h"

namespace aolib {
namespace {

class EvictionGLTest : public GLTest {
protected:
    static constexpr int kFaceSize = 64;

    /// Room for a number of cube maps.
    static float budgetFor(double cubeMaps, int faceSize = kFaceSize) {
        return static_cast<float>(cubeMaps * kFaces *
                                  static_cast<double>(FaceStore::bytesPerLayer(faceSize)) /
                                  (1 << 20));
    }
    static Options options(double cubeMaps) {
        Options o = atOnce();
        o.radius = 1.0F;
        o.horizonSplit = {.directions = 4, .steps = 4};
        o.cubeMaps.faceSize = kFaceSize;
        o.cubeMaps.screenSpaceFallback = false; // what cube maps know alone
        o.cubeMaps.memoryBudget = budgetFor(cubeMaps);
        return o;
    }
    SmallHost hostWith(const Options& o) { return SmallHost(gl, loader, rooms(kRooms), o, 96, 54); }

    void lookIntoRoom(SmallHost& host, float room) {
        const glm::vec3 eye = walkedTo(room);
        host.lookAt(eye, eye + glm::vec3(0.5F, -0.1F, 0.0F));
    }
    void draw(SmallHost& host) {
        ASSERT_TRUE(host.frame().ok()) << host.ao().lastStatus().message();
        gl.Finish(); // so that the next frame has the survey's answer
    }
    std::set<CubeMapId> ids(SmallHost& host) {
        std::set<CubeMapId> all;
        for (const CubeMapInfo& info : host.ao().cubeMaps()) {
            all.insert(info.id);
        }
        return all;
    }
    std::size_t inUse() {
        const std::size_t bytes = GlObjects(gl, loader).bytes();
        (void)takeDriverMessages(); // about textures asked for as those of another kind
        return bytes;
    }
    /// To the last room and back, in steps of a frame.
    template <typename Each>
    void walk(SmallHost& host, int framesPerRoom, Each each) {
        const int frames = framesPerRoom * (kRooms - 1);
        for (int i = 0; i <= 2 * frames && !HasFatalFailure(); ++i) {
            const int along = i <= frames ? i : 2 * frames - i;
            lookIntoRoom(host, static_cast<float>(along) / static_cast<float>(framesPerRoom));
            draw(host);
            each();
        }
    }

    struct Change {
        double largest = 0.0; ///< of W
        double share = 0.0;   ///< of pixels, that get lighter or darker by more than 0.02
    };
    static Change changeOf(const std::vector<float>& a, const std::vector<float>& b) {
        Change change;
        for (std::size_t i = 0; i < a.size(); ++i) {
            const double difference = std::abs(double{a[i]} - double{b[i]});
            change.largest = std::max(change.largest, difference);
            change.share += difference > 0.02 ? 1.0 / static_cast<double>(a.size()) : 0.0;
        }
        return change;
    }
    /// What cube maps that go change in the picture, on a walk past all rooms.
    Change whereOneGoes(double cubeMaps) {
        Options o = options(cubeMaps);
        o.frameBudget = 1000.0F;
        o.blur.enabled = false;
        SmallHost host = hostWith(o);
        std::uint64_t evicted = 0;
        std::vector<float> before;
        Change most;
        for (int i = 0; i <= 480; ++i) { // each view for four frames: what differs then is ours
            lookIntoRoom(host, static_cast<float>(i / 4 * 4) / 480.0F * (kRooms - 1));
            draw(host);
            const std::vector<float> now = host.visibility().visibility;
            if (i % 4 != 0 && host.ao().statistics().cubeMapsEvicted > evicted) {
                const Change change = changeOf(before, now);
                most = {std::max(most.largest, change.largest), std::max(most.share, change.share)};
            }
            evicted = host.ao().statistics().cubeMapsEvicted;
            before = now;
        }
        EXPECT_GE(evicted, 2U);
        return most;
    }

    static constexpr int kRooms = 5;
};

TEST_P(EvictionGLTest, TheBudgetIsKeptInEveryFrameOfAWalkToAndFro) {
    SmallHost host = hostWith(options(2.9));
    Options o = host.ao().options();
    o.cubeMaps.place = false;
    ASSERT_TRUE(host.ao().setOptions(o).ok());
    lookIntoRoom(host, 0.0F);
    draw(host);
    const std::size_t before = inUse();
    o.cubeMaps.place = true;
    ASSERT_TRUE(host.ao().setOptions(o).ok());
    const std::size_t budget = 2 * kFaces * FaceStore::bytesPerLayer(kFaceSize);
    std::set<CubeMapId> seen;
    walk(host, 40, [&] {
        ASSERT_LE(inUse() - before, budget + 5 * FaceStore::bytesPerLayer(kFaceSize));
        ASSERT_LE(host.ao().cubeMaps().size(), 2U);
        seen.merge(ids(host));
    });
    EXPECT_GE(seen.size(), 5U) << "one per room at least, and again on the way back";
    EXPECT_EQ(host.ao().statistics().cubeMapsEvicted, seen.size() - host.ao().cubeMaps().size());
    EXPECT_GE(host.ao().statistics().coverage, 0.75F) << "back where it began";
}

TEST_P(EvictionGLTest, WithRoomForAllNoneGoes) {
    SmallHost host = hostWith(options(100.0));
    walk(host, 8, [] {});
    EXPECT_EQ(host.ao().statistics().cubeMapsEvicted, 0U);
    Options o = host.ao().options();
    o.cubeMaps.memoryBudget = 0.0F;
    SmallHost unlimited = hostWith(o);
    walk(unlimited, 8, [] {});
    EXPECT_EQ(unlimited.ao().cubeMaps().size(), host.ao().cubeMaps().size());
}

TEST_P(EvictionGLTest, AViewAtRestComesToRest) {
    Options o = options(1.01);
    o.frameBudget = 1000.0F;
    SmallHost host = hostWith(o);
    for (const float room : {0.0F, 1.0F, 0.5F}) {
        lookIntoRoom(host, room);
        for (int i = 0; i < 120; ++i) {
            draw(host);
        }
        const std::set<CubeMapId> settled = ids(host);
        const std::uint64_t evicted = host.ao().statistics().cubeMapsEvicted;
        for (int i = 0; i < 60; ++i) {
            draw(host);
        }
        EXPECT_EQ(ids(host), settled);
        EXPECT_EQ(host.ao().statistics().cubeMapsEvicted, evicted);
        EXPECT_TRUE(host.ao().statistics().converged);
        EXPECT_GE(host.ao().statistics().coverage, 0.75F) << "room " << room;
    }
}

TEST_P(EvictionGLTest, WhatNobodySeesGoesUnseen) {
    EXPECT_LE(whereOneGoes(3.01).share, 0.005);
}

TEST_P(EvictionGLTest, WhatIsSeenFadesBeforeItGoes) {
    EXPECT_LE(whereOneGoes(2.01).largest, 0.09) << "0.14 where it goes at once";
}

TEST_P(EvictionGLTest, ThoseByHandStay) {
    SmallHost host = hostWith(options(2.01));
    const CubeMapId first = *host.ao().addCubeMap(walkedTo(0.0F));
    const CubeMapId second = *host.ao().addCubeMap(walkedTo(1.0F));
    const auto third = host.ao().addCubeMap(walkedTo(2.0F));
    ASSERT_FALSE(third.ok());
    EXPECT_EQ(third.status().code(), StatusCode::OutOfMemory);
    EXPECT_NE(third.status().message().find("memoryBudget"), std::string::npos);
    walk(host, 8, [] {});
    EXPECT_EQ(ids(host), (std::set<CubeMapId>{first, second}));
    EXPECT_EQ(host.ao().statistics().cubeMapsEvicted, 0U);
    ASSERT_TRUE(host.ao().removeCubeMap(first).ok());
    lookIntoRoom(host, 3.0F);
    draw(host);
    draw(host);
    draw(host);
    EXPECT_EQ(host.ao().cubeMaps().size(), 2U) << "there is room for one by coverage again";
    EXPECT_TRUE(host.ao().addCubeMap(walkedTo(2.0F)).ok()) << "which gives way";
    EXPECT_EQ(host.ao().statistics().cubeMapsEvicted, 1U);
}

TEST_P(EvictionGLTest, ASmallerBudgetIsKeptAtOnce) {
    SmallHost host = hostWith(options(5.01));
    for (const float room : {0.0F, 1.0F, 2.0F, 3.0F}) {
        ASSERT_TRUE(host.ao().addCubeMap(walkedTo(room)).ok());
    }
    lookIntoRoom(host, 3.0F);
    draw(host);
    Options o = host.ao().options();
    o.cubeMaps.memoryBudget = budgetFor(1.5);
    ASSERT_TRUE(host.ao().setOptions(o).ok());
    draw(host);
    draw(host);
    EXPECT_EQ(host.ao().cubeMaps().size(), 1U);
    EXPECT_LE(static_cast<double>(host.ao().statistics().bytesKept),
              double{o.cubeMaps.memoryBudget} * (1 << 20));
    o.cubeMaps.faceSize = 2 * kFaceSize; // four times the bytes
    EXPECT_EQ(host.ao().setOptions(o).code(), StatusCode::InvalidOption);
}

TEST_P(EvictionGLTest, DetailInViewPushesOutWhatNobodySees) {
    constexpr int kFine = 128; // the least that has detail
    Options o = options(1.01);
    o.estimator = Estimator::RayTraced;
    o.rayTraced.rays = 16;
    o.cubeMaps.refineStaticViews = false;
    o.frameBudget = 1000.0F;
    o.cubeMaps.faceSize = kFine;
    o.cubeMaps.memoryBudget = budgetFor(3.01, kFine);
    SmallHost host(gl, loader, rooms(kRooms), o, 320, 180);
    host.ao().setTexelTracer(std::move(*createTexelTracer(1)));
    for (const float room : {0.0F, 3.0F}) {
        lookIntoRoom(host, room);
        bool converged = false;
        for (int i = 0; i < 2000 && !(converged && i > 150); ++i) {
            draw(host);
            const Statistics s = host.ao().statistics();
            converged = s.converged;
            ASSERT_LE(static_cast<double>(s.bytesKept),
                      double{o.cubeMaps.memoryBudget} * (1 << 20));
            std::this_thread::sleep_for(std::chrono::milliseconds(1)); // for the tracer's worker
        }
        EXPECT_TRUE(converged) << "room " << room;
    }
    EXPECT_EQ(host.ao().cubeMaps().size(), 1U);
    EXPECT_EQ(host.ao().statistics().cubeMapsEvicted, 1U);
}

INSTANTIATE_TEST_SUITE_P(One, EvictionGLTest, testing::Values(testContexts().front()), nameOf);

} // namespace
} // namespace aolib
