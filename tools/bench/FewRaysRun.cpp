#include "bench/FewRaysRun.h"

#include <cmath>
#include <vector>

#include "bench/HostedFrames.h"
#include "raytracing/CosineSampling.h"
#include "reference/ParallelLoop.h"

namespace aolib::bench {

namespace {

/// So that no frame's random numbers are those of the truth.
constexpr std::uint64_t kFirstSeed = 1000;

/// W of one receiver by cosine-weighted rays, one in each of `across` x `across` cells.
float traced(const RayScene& scene, const Receiver& receiver, double radius, int across,
             RandomSequence random) {
    const glm::dmat3 basis = basisAbout(receiver.normal);
    const double cell = 1.0 / double(across);
    int blocked = 0;
    for (int row = 0; row < across; ++row) {
        for (int column = 0; column < across; ++column) {
            const double x = (double(column) + random.next()) * cell;
            const double y = (double(row) + random.next()) * cell;
            const glm::dvec3 direction = basis * cosineDirection({x, y});
            blocked += scene.occluded(receiver.position, direction, 0.0, radius) ? 1 : 0;
        }
    }
    return static_cast<float>(1.0 - double(blocked) * cell * cell);
}

} // namespace

Measurement measureFewRays(const FewRaysMethod& method, const OpenedScene& scene,
                           const BenchCase& which, const Truth& truth, const PictureSize& size,
                           const Patience& patience) {
    const Receivers seen =
        findReceivers(scene.rays, scene.cameras[which.camera], size, allPixels(size));
    const int across = static_cast<int>(std::lround(std::sqrt(double(method.raysPerPixel))));
    const double radius = which.radiusShare * scene.diagonal;
    std::vector<float> picture(size.pixels(), -1.0F);
    std::uint64_t seed = kFirstSeed;
    const auto drawFrame = [&] {
        const Clock::time_point begin = Clock::now();
        const auto body = [&](std::size_t from, std::size_t to) {
            for (std::size_t i = from; i < to; ++i) {
                picture[seen.pixels[i]] = traced(scene.rays, seen.points[i], radius, across,
                                                 RandomSequence(seed, seen.pixels[i]));
            }
        };
        parallelLoop(seen.pixels.size(), 0, body, {});
        ++seed;
        return millisecondsSince(begin);
    };
    Measurement m;
    m.firstMs = drawFrame();
    m.worstFrameMs = m.firstMs;
    m.framesToConverge = 1;
    m.first = compareWithTruth(picture, truth);
    m.final = m.first;
    m.path = {{m.firstMs, m.first.rmse}};
    std::vector<double> times;
    for (int i = 0; i < patience.frames * patience.repeat; ++i) {
        times.push_back(drawFrame());
    }
    m.frameMs = spreadOf(std::move(times));
    m.buildMs = spreadOf({0.0});
    m.convergedMs = spreadOf({m.firstMs});
    m.coverage = 1.0;
    return m;
}

} // namespace aolib::bench
