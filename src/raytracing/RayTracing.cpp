#include <aolib/RayTracing.h>

#include <algorithm>
#include <new>
#include <string>

#include "parallel/CoreCount.h"
#include "raytracing/RayScene.h"
#include "raytracing/TexelTracer.h"

namespace aolib {

namespace {

constexpr int mostThreads = 1024;

/// One per core but one, which draws.
int spareCores() {
    return std::max(1, coreCount() - 1);
}

} // namespace

Result<std::unique_ptr<AbstractTexelTracer>> createTexelTracer(int threads) {
    if (threads < 0 || threads > mostThreads) {
        return AoStatus(StatusCode::InvalidOption, "threads is " + std::to_string(threads) +
                                                       ", must be 0 to " +
                                                       std::to_string(mostThreads));
    }
    try {
        if (const Result<RayScene> probe = RayScene::create({}); !probe) {
            return probe.status();
        }
        return std::unique_ptr<AbstractTexelTracer>(
            std::make_unique<TexelTracer>(threads == 0 ? spareCores() : threads));
    } catch (const std::bad_alloc&) {
        return AoStatus(StatusCode::OutOfMemory, "no memory left for a texel tracer");
    }
}

} // namespace aolib
