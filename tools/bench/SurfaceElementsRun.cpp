#include "bench/SurfaceElementsRun.h"

#include <utility>
#include <vector>

#include "bench/HostedFrames.h"
#include "bench/SurfaceElements.h"
#include "parallel/ParallelLoop.h"

namespace aolib::bench {

namespace {

/// Interpolates the elements' values to the pixels, as drawing with a colour per vertex does.
/// Returns how long that took, milliseconds.
double drawFrame(const SurfaceElements& elements, const Receivers& seen,
                 std::vector<float>& picture) {
    const Clock::time_point begin = Clock::now();
    const auto body = [&](std::size_t from, std::size_t to) {
        for (std::size_t i = from; i < to; ++i) {
            const Hit& hit = seen.hits[i];
            picture[seen.pixels[i]] =
                elements.visibility(hit.triangle, hit.u, hit.v, glm::vec3(seen.points[i].normal));
        }
    };
    parallelLoop(seen.pixels.size(), 0, body, {});
    return millisecondsSince(begin);
}

} // namespace

Measurement measureSurfaceElements(const SurfaceElementsMethod& method, const OpenedScene& scene,
                                   const BenchCase& which, const Truth& truth,
                                   const PictureSize& size, const TimingSettings& timing) {
    const NamedCamera& camera = scene.cameras[which.camera];
    Receivers seen = findReceivers(scene.rays, camera, size, allPixels(size));
    followPicture(scene.rays, camera, size, truth.drawn, seen);
    SurfaceElements::Settings settings;
    settings.radius = which.radiusShare * scene.diagonal;
    settings.elements = static_cast<std::size_t>(method.elements);
    std::vector<float> picture(size.pixels(), -1.0F);
    std::vector<double> builds;
    std::vector<double> frames;
    for (int turn = 0; turn < timing.repeat; ++turn) {
        const Clock::time_point begin = Clock::now();
        const SurfaceElements elements(scene.rays.mesh(), settings);
        builds.push_back(millisecondsSince(begin));
        for (int i = 0; i <= timing.frames; ++i) {
            const double ms = drawFrame(elements, seen, picture);
            if (i > 0) { // the first warms up
                frames.push_back(ms);
            }
        }
    }
    Measurement m;
    m.frameMs = spreadOf(std::move(frames));
    m.buildMs = spreadOf(builds);
    m.convergedMs = spreadOf(std::move(builds));
    m.firstMs = m.convergedMs.median;
    m.worstFrameMs = m.firstMs;
    m.framesToConverge = 1;
    m.first = compareWithTruth(picture, truth);
    m.final = m.first;
    m.path = {{m.firstMs, m.first.rmse}};
    m.coverage = 1.0;
    return m;
}

} // namespace aolib::bench
