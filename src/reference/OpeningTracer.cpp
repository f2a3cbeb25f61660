#include "reference/OpeningTracer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include <glm/geometric.hpp>

#include "raytracing/CosineSampling.h"

namespace aolib {

namespace {

glm::vec3 unitOrZero(const glm::dvec3& v) {
    const double length = glm::length(v);
    return length > 0.0 ? glm::vec3(v / length) : glm::vec3(0.0F);
}

Opening openingOf(const RayScene& scene, const Receiver& receiver, int cells, std::uint64_t seed,
                  std::uint64_t index) {
    const double lift =
        receiver.lift < 0.0 ? scene.clearance(receiver.position, receiver.normal) : receiver.lift;
    const glm::dvec3 origin = receiver.position + lift * receiver.normal;
    const glm::dmat3 basis = basisAbout(receiver.normal);
    RandomSequence random(seed, index);
    double visibility = 0.0;
    double open = 0.0;
    glm::dvec3 byCosine(0.0);
    glm::dvec3 plain(0.0);
    for (int cell = 0; cell < cells * cells; ++cell) {
        const double cosine = (double(cell % cells) + random.next()) / double(cells);
        const double turn =
            2.0 * std::numbers::pi * (double(cell / cells) + random.next()) / double(cells);
        const double level = std::sqrt(1.0 - cosine * cosine);
        const glm::dvec3 direction =
            basis * glm::dvec3(level * std::cos(turn), level * std::sin(turn), cosine);
        if (scene.occluded(origin, direction)) {
            continue;
        }
        visibility += 2.0 * cosine;
        open += 1.0;
        byCosine += cosine * direction;
        plain += direction;
    }
    const double count = double(cells) * double(cells);
    return {static_cast<float>(std::min(visibility / count, 1.0)), unitOrZero(byCosine),
            static_cast<float>(open / count), unitOrZero(plain)};
}

} // namespace

std::vector<Opening> traceOpenings(const RayScene& scene, std::span<const Receiver> receivers,
                                   int rays, std::uint64_t seed, const TraceProgress& progress) {
    const int cells = static_cast<int>(std::ceil(std::sqrt(double(std::max(rays, 1)))));
    std::vector<Opening> openings(receivers.size());
    const auto body = [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            openings[i] = openingOf(scene, receivers[i], cells, seed, i);
        }
    };
    parallelLoop(receivers.size(), 0, body, progress);
    return openings;
}

} // namespace aolib
