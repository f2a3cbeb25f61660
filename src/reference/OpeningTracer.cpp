#include "reference/OpeningTracer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include <glm/geometric.hpp>

#include <aolib/lighting/SectorTable.h>

#include "raytracing/CosineSampling.h"

namespace aolib {

namespace {

constexpr std::size_t sectorCount = std::tuple_size_v<OpenSectors>;

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
    std::array<double, sectorCount> openIn{};
    std::array<double, sectorCount> allIn{};
    for (int cell = 0; cell < cells * cells; ++cell) {
        const double cosine = (double(cell % cells) + random.next()) / double(cells);
        const double turn =
            2.0 * std::numbers::pi * (double(cell / cells) + random.next()) / double(cells);
        const double level = std::sqrt(1.0 - cosine * cosine);
        const glm::dvec3 direction =
            basis * glm::dvec3(level * std::cos(turn), level * std::sin(turn), cosine);
        const auto sector =
            static_cast<std::size_t>(lighting::sectorOfDirection(glm::vec3(direction)));
        allIn[sector] += cosine;
        if (scene.occluded(origin, direction)) {
            continue;
        }
        openIn[sector] += cosine;
        visibility += 2.0 * cosine;
        open += 1.0;
        byCosine += cosine * direction;
        plain += direction;
    }
    const double count = double(cells) * double(cells);
    Opening opening{static_cast<float>(std::min(visibility / count, 1.0)),
                    unitOrZero(byCosine),
                    static_cast<float>(open / count),
                    unitOrZero(plain),
                    {}};
    for (std::size_t k = 0; k < opening.sectors.size(); ++k) {
        opening.sectors[k] =
            allIn[k] > 0.0 ? static_cast<float>(openIn[k] / allIn[k]) : opening.visibility;
    }
    return opening;
}

} // namespace

std::vector<Opening> traceOpenings(const RayScene& scene, std::span<const Receiver> receivers,
                                   int rays, std::uint64_t seed, const LoopProgress& progress) {
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
