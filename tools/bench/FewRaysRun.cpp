#include "bench/FewRaysRun.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "bench/HostedFrames.h"
#include "parallel/ParallelLoop.h"
#include "raytracing/CosineSampling.h"
#include "raytracing/GroupTracer.h"

namespace aolib::bench {

namespace {

/// Pixels along the edge of the blocks that are traced side by side.
constexpr int kBlock = 4;
static_assert(std::size_t{kBlock * kBlock} == SurfaceGroup::capacity);
/// Groups that one worker traces without looking up.
constexpr std::size_t kGroupsAtOnce = 64;

/// The surface points of a picture in blocks of pixels, `texel` being the pixel.
std::vector<SurfaceGroup> groupsOf(const RayScene& scene, const Receivers& seen,
                                   const PictureSize& size) {
    const int columns = (size.width + kBlock - 1) / kBlock;
    const int rows = (size.height + kBlock - 1) / kBlock;
    std::vector<SurfaceGroup> groups(std::size_t(columns) * std::size_t(rows));
    for (std::size_t i = 0; i < seen.points.size(); ++i) {
        const int x = static_cast<int>(seen.pixels[i]) % size.width;
        const int y = static_cast<int>(seen.pixels[i]) / size.width;
        const auto block = static_cast<std::size_t>(y / kBlock * columns + x / kBlock);
        groups[block].add({glm::vec3(scene.toFrame(seen.points[i].position)),
                           glm::mat3(basisAbout(seen.points[i].normal)),
                           {},
                           sequenceSeed(0, x, y),
                           seen.pixels[i]});
    }
    std::erase_if(groups, [](const SurfaceGroup& group) { return group.count == 0; });
    return groups;
}

/// Traces every pixel of the groups: rays from `start` on of each pixel's own sequence.
void tracePicture(const RayScene& scene, float radius, const std::vector<SurfaceGroup>& groups,
                  std::uint32_t start, int rays, std::vector<float>& picture) {
    const std::size_t pieces = (groups.size() + kGroupsAtOnce - 1) / kGroupsAtOnce;
    const auto body = [&](std::size_t begin, std::size_t end) {
        GroupTracer tracer(scene, Falloff::Step, radius);
        const std::size_t last = std::min(end * kGroupsAtOnce, groups.size());
        for (std::size_t g = begin * kGroupsAtOnce; g < last; ++g) {
            GroupTracer::Sums sums{};
            tracer.trace(groups[g], start, rays, sums);
            for (std::size_t i = 0; i < groups[g].count; ++i) {
                picture[groups[g].surfaces[i].texel] = 1.0F - sums[i] / static_cast<float>(rays);
            }
        }
    };
    parallelLoop(pieces, 0, body, {});
}

} // namespace

Measurement measureFewRays(const FewRaysMethod& method, const OpenedScene& scene,
                           const BenchCase& which, const Truth& truth, const PictureSize& size,
                           const TimingSettings& timing) {
    const NamedCamera& camera = scene.cameras[which.camera];
    Receivers seen = findReceivers(scene.rays, camera, size, allPixels(size));
    followPicture(scene.rays, camera, size, truth.drawn, seen);
    const std::vector<SurfaceGroup> groups = groupsOf(scene.rays, seen, size);
    const auto radius = static_cast<float>(which.radiusShare * scene.diagonal);
    const int rays = method.raysPerPixel;
    std::vector<float> picture(size.pixels(), -1.0F);
    std::uint32_t start = 0;
    const auto drawFrame = [&] {
        const Clock::time_point begin = Clock::now();
        tracePicture(scene.rays, radius, groups, start, rays, picture);
        start += static_cast<std::uint32_t>(rays); // other rays in every frame
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
    for (int i = 0; i < timing.frames * timing.repeat; ++i) {
        times.push_back(drawFrame());
    }
    m.frameMs = spreadOf(std::move(times));
    m.buildMs = spreadOf({0.0});
    m.convergedMs = spreadOf({m.firstMs});
    m.coverage = 1.0;
    return m;
}

} // namespace aolib::bench
