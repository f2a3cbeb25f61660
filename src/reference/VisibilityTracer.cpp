#include "reference/VisibilityTracer.h"

#include <cmath>
#include <limits>
#include <string>

#include <glm/geometric.hpp>

#include "raytracing/CosineSampling.h"
#include "shared/falloff.h"

namespace aolib {

namespace {

constexpr int mostRays = 1 << 24;

bool finite(const glm::dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

AoStatus check(std::span<const Receiver> receivers) {
    for (std::size_t i = 0; i < receivers.size(); ++i) {
        const Receiver& receiver = receivers[i];
        if (!finite(receiver.position) || !std::isfinite(receiver.lift)) {
            return {StatusCode::InvalidPosition,
                    "position or lift of receiver " + std::to_string(i) + " is not finite"};
        }
        if (!finite(receiver.normal) || receiver.normal == glm::dvec3(0.0)) {
            return {StatusCode::InvalidNormal,
                    "normal of receiver " + std::to_string(i) + " is zero or not finite"};
        }
    }
    return {};
}

} // namespace

VisibilityTracer::VisibilityTracer(const RayScene& scene, const TraceSettings& settings)
    : scene_(&scene), settings_(settings),
      cells_(static_cast<int>(std::ceil(std::sqrt(0.5 * double(settings.rays))))) {}

Result<VisibilityTracer> VisibilityTracer::create(const RayScene& scene,
                                                  const TraceSettings& settings) {
    if (settings.rays < 2 || settings.rays > mostRays) {
        return AoStatus(StatusCode::InvalidOption, "rays is " + std::to_string(settings.rays) +
                                                       ", must be 2 to " +
                                                       std::to_string(mostRays));
    }
    if (settings.falloff != Falloff::Off &&
        !(settings.radius > 0.0 && std::isfinite(settings.radius))) {
        return AoStatus(StatusCode::InvalidOption,
                        "radius is " + std::to_string(settings.radius) + ", must be above 0");
    }
    if (settings.threads < 0) {
        return AoStatus(StatusCode::InvalidOption,
                        "threads is " + std::to_string(settings.threads) + ", must be 0 or more");
    }
    return VisibilityTracer(scene, settings);
}

double VisibilityTracer::occlusion(const glm::dvec3& origin, const glm::dvec3& direction) const {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    switch (settings_.falloff) {
    case Falloff::Step:
        return scene_->occluded(origin, direction, 0.0, settings_.radius) ? 1.0 : 0.0;
    case Falloff::Off:
        return scene_->occluded(origin, direction, 0.0, infinity) ? 1.0 : 0.0;
    case Falloff::Exp:
        break;
    }
    const std::optional<Hit> hit =
        scene_->intersect(origin, direction, 0.0, double{shared::kExpReach} * settings_.radius);
    return hit ? std::exp(-hit->distance / settings_.radius) : 0.0;
}

VisibilityEstimate VisibilityTracer::estimate(const Receiver& receiver, std::uint64_t index) const {
    const glm::dvec3 normal = glm::normalize(receiver.normal);
    const double lift =
        receiver.lift < 0.0 ? scene_->clearance(receiver.position, normal) : receiver.lift;
    const glm::dvec3 origin = receiver.position + lift * normal;
    const glm::dmat3 basis = basisAbout(normal);
    RandomSequence random(settings_.seed, index);
    const double cell = 1.0 / double(cells_);
    const auto ray = [&](int column, int row) {
        const double x = (double(column) + random.next()) * cell;
        const double y = (double(row) + random.next()) * cell;
        return occlusion(origin, basis * cosineDirection({x, y}));
    };
    double sum = 0.0;
    double squares = 0.0;
    for (int row = 0; row < cells_; ++row) {
        for (int column = 0; column < cells_; ++column) {
            const double first = ray(column, row);
            const double second = ray(column, row);
            sum += first + second;
            squares += (first - second) * (first - second);
        }
    }
    const double cells = double(cells_) * double(cells_);
    return {1.0 - sum / (2.0 * cells), squares / (4.0 * cells * cells)};
}

Result<VisibilityList> VisibilityTracer::trace(std::span<const Receiver> receivers,
                                               const LoopProgress& progress) const {
    if (AoStatus status = check(receivers); !status) {
        return status;
    }
    VisibilityList list;
    list.visibility.assign(receivers.size(), -1.0F);
    list.standardError.assign(receivers.size(), -1.0F);
    const auto body = [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const VisibilityEstimate estimated = estimate(receivers[i], i);
            list.visibility[i] = static_cast<float>(estimated.visibility);
            list.standardError[i] = static_cast<float>(std::sqrt(estimated.variance));
        }
    };
    list.complete = parallelLoop(receivers.size(), settings_.threads, body, progress);
    list.noise = noiseOf(list.standardError);
    return list;
}

double noiseOf(std::span<const float> standardErrors) {
    double sum = 0.0;
    std::size_t count = 0;
    for (const float error : standardErrors) {
        if (error >= 0.0F) {
            sum += double{error} * double{error};
            ++count;
        }
    }
    return count == 0 ? 0.0 : std::sqrt(sum / static_cast<double>(count));
}

} // namespace aolib
