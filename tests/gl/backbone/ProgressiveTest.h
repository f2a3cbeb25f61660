#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>
#include <vector>

#include <aolib/RayTracing.h>

#include "SmallScene.h"

namespace aolib {

/// A host with a tracer, whose cube maps are computed within a budget, over many frames.
class ProgressiveTest : public GLTest {
protected:
    using Picture = std::vector<float>;
    static constexpr int kMostFrames = 4000;

    /// What cube maps know alone.
    static Options options(Estimator estimator) {
        Options o;
        o.cubeMaps.screenSpaceFallback = false;
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
            const AoStatus status = host.frame();
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

} // namespace aolib
