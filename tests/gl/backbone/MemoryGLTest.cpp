// GPU memory as GL tells it: what a cube map takes while it is computed, and what it keeps.
#include <chrono>
#include <thread>

#include <aolib/RayTracing.h>

#include "GlObjects.h"
#include "SmallScene.h"
#include "backbone/cubemaps/TileTable.h"

namespace aolib {
namespace {

class MemoryGLTest : public GLTest {
protected:
    static constexpr int kFaceSize = 64;
    static constexpr std::size_t kTexels = std::size_t{6} * kFaceSize * kFaceSize;
    /// Two numbers per tile, which say where its detail lies.
    static constexpr std::size_t kPages =
        std::size_t{6} * (kFaceSize / TileTable::kTile) * (kFaceSize / TileTable::kTile) * 4;

    /// All textures and buffers of the context, bytes.
    std::size_t inUse() {
        const std::size_t bytes = GlObjects(gl, loader).bytes();
        (void)takeDriverMessages(); // about textures asked for as those of another kind
        return bytes;
    }

    SmallHost hostWith(Estimator estimator, float budget) {
        Options o;
        o.estimator = estimator;
        o.radius = 1.5F;
        o.frameBudget = budget;
        o.cubeMaps.faceSize = kFaceSize;
        o.cubeMaps.place = false;
        o.layeredIntervals = {.slices = 4, .steps = 8};
        o.rayTraced.rays = 16;
        o.cubeMaps.refineStaticViews = false;   // which has buffers of its own, per frame
        o.cubeMaps.screenSpaceFallback = false; // and so has this
        SmallHost host(gl, loader, boxOnFloor(), o);
        host.ao().setTexelTracer(std::move(*createTexelTracer(1)));
        host.lookAt({4, 24, 40}, {0, 0.5F, 0}); // so far away that no view asks for detail
        return host;
    }
};

TEST_P(MemoryGLTest, WhatABuildTakesIsGivenBackAndThreeBytesPerTexelAreKept) {
    for (const Estimator estimator :
         {Estimator::HorizonSplit, Estimator::LayeredIntervals, Estimator::RayTraced}) {
        SmallHost host = hostWith(estimator, 1e-6F);
        ASSERT_TRUE(host.frame().ok());
        const std::size_t before = inUse();
        ASSERT_TRUE(host.ao().addCubeMap({0.5F, 3, 5}).ok());
        std::size_t most = 0;
        Statistics s;
        for (int frame = 0; frame < 4000 && (frame == 0 || !s.converged || s.bytesBuilding > 0);
             ++frame) {
            ASSERT_TRUE(host.frame().ok());
            s = host.ao().statistics();
            ASSERT_EQ(inUse() - before, s.bytesKept + s.bytesBuilding) << "frame " << frame;
            most = std::max(most, s.bytesBuilding);
            std::this_thread::sleep_for(std::chrono::milliseconds(1)); // for the tracer's worker
        }
        ASSERT_TRUE(s.converged);
        EXPECT_EQ(s.bytesBuilding, 0U) << "given back once nobody has asked for more";
        EXPECT_EQ(most, host.ao().cubeMaps().front().captureBytes);
        EXPECT_EQ(most > 8 * kTexels, estimator != Estimator::RayTraced);
        EXPECT_EQ(inUse() - before, 3 * kTexels + kPages);
        ASSERT_TRUE(host.ao().clear().ok());
        EXPECT_EQ(inUse(), before);
    }
}

TEST_P(MemoryGLTest, ABuildAtOnceLeavesNothing) {
    for (const Estimator estimator : {Estimator::HorizonSplit, Estimator::LayeredIntervals}) {
        SmallHost host = hostWith(estimator, 0.0F);
        ASSERT_TRUE(host.frame().ok());
        const std::size_t before = inUse();
        ASSERT_TRUE(host.ao().addCubeMap({0.5F, 3, 5}).ok());
        EXPECT_EQ(inUse() - before, 3 * kTexels + kPages);
    }
}

AOLIB_FOR_ALL_CONTEXTS(MemoryGLTest);

} // namespace
} // namespace aolib
