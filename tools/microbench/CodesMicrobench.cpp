// What shaders and C++ share: packed normals, packed distances, sector masks. The C++ side is
// measured; it tells how many operations there are, not what a GPU makes of them.
#include <vector>

#include <benchmark/benchmark.h>
#include <glm/geometric.hpp>

#include "raytracing/CosineSampling.h"
#include "shared/distance_code.h"
#include "shared/octahedral.h"
#include "shared/sector_mask.h"

namespace aolib {
namespace {

constexpr std::size_t kCount = 4096;

std::vector<glm::vec3> directions() {
    std::vector<glm::vec3> list;
    RandomSequence random(1, 0);
    while (list.size() < kCount) {
        const glm::vec3 v(random.next() - 0.5, random.next() - 0.5, random.next() - 0.5);
        if (glm::length(v) > 0.05F) {
            list.push_back(glm::normalize(v));
        }
    }
    return list;
}

std::vector<float> shares(std::uint64_t seed) {
    std::vector<float> list;
    RandomSequence random(seed, 0);
    while (list.size() < kCount) {
        list.push_back(static_cast<float>(random.next()));
    }
    return list;
}

void countItems(benchmark::State& state) {
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kCount));
}

void OctahedralRoundTrip(benchmark::State& state) {
    const std::vector<glm::vec3> normals = directions();
    for (auto turn : state) {
        for (const glm::vec3& normal : normals) {
            benchmark::DoNotOptimize(shared::decodeNormal(shared::encodeNormal(normal)));
        }
    }
    countItems(state);
}
BENCHMARK(OctahedralRoundTrip);

void DistanceCodeRoundTrip(benchmark::State& state) {
    constexpr float nearest = 0.1F;
    const glm::vec2 span = shared::distanceSpan(nearest, 1024.0F * nearest);
    const std::vector<float> distances = shares(1);
    for (auto turn : state) {
        for (const float share : distances) {
            const float code = shared::encodeDistance(nearest + 100.0F * share, span);
            benchmark::DoNotOptimize(shared::decodeDistance(code, span));
        }
    }
    countItems(state);
}
BENCHMARK(DistanceCodeRoundTrip);

void SectorMasks(benchmark::State& state) {
    const std::vector<float> from = shares(1);
    const std::vector<float> width = shares(2);
    for (auto turn : state) {
        glm::uvec2 mask(0U);
        for (std::size_t i = 0; i < kCount; ++i) {
            const glm::uvec2 sectors = shared::sectorsBetween(from[i], from[i] + 0.1F * width[i]);
            benchmark::DoNotOptimize(
                shared::shareSet(glm::uvec2(sectors.x & ~mask.x, sectors.y & ~mask.y)));
            mask = (i & 31U) == 0 ? glm::uvec2(0U)
                                  : glm::uvec2(mask.x | sectors.x, mask.y | sectors.y);
        }
        benchmark::DoNotOptimize(mask);
    }
    countItems(state);
}
BENCHMARK(SectorMasks);

} // namespace
} // namespace aolib
