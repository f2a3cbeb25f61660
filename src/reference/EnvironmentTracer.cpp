#include "reference/EnvironmentTracer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <utility>

#include <glm/geometric.hpp>

#include "raytracing/CosineSampling.h"

namespace aolib {

namespace {

constexpr int mostLightRays = 1 << 24;

double brightness(const glm::vec3& radiance) {
    return (double{radiance.r} + double{radiance.g} + double{radiance.b}) / 3.0;
}

/// The steradians of a texel in a row.
double texelAngle(const lighting::EnvironmentMap& map, int row) {
    const double low = std::numbers::pi * (double(row) / double(map.height) - 0.5);
    const double high = std::numbers::pi * (double(row + 1) / double(map.height) - 0.5);
    return 2.0 * std::numbers::pi / double(map.width) * (std::sin(high) - std::sin(low));
}

/// Where `value` falls among sums that grow, and how far into that step it is.
std::pair<int, double> find(std::span<const double> sums, double share) {
    const double value = share * sums.back();
    const auto found = std::upper_bound(sums.begin(), sums.end(), value);
    const auto last = static_cast<std::ptrdiff_t>(sums.size()) - 1;
    const std::ptrdiff_t step = std::min(found - sums.begin(), last);
    const double below = step == 0 ? 0.0 : sums[static_cast<std::size_t>(step - 1)];
    const double height = sums[static_cast<std::size_t>(step)] - below;
    return {static_cast<int>(step), height > 0.0 ? (value - below) / height : 0.5};
}

/// Everything a receiver needs, prepared once.
class LightTracer {
public:
    LightTracer(const RayScene& scene, const lighting::EnvironmentMap& map,
                const LightSettings& settings)
        : scene_(scene), sampler_(map), seed_(settings.seed),
          cells_(static_cast<int>(std::ceil(std::sqrt(double(settings.rays) / 4.0)))) {}

    /// Two independent estimates, of half the rays each.
    std::array<glm::dvec3, 2> estimate(const Receiver& receiver, std::uint64_t index) const;

private:
    const RayScene& scene_;
    EnvironmentSampler sampler_;
    std::uint64_t seed_;
    int cells_; ///< along each side of a grid; there are two a strategy
};

std::array<glm::dvec3, 2> LightTracer::estimate(const Receiver& receiver,
                                                std::uint64_t index) const {
    const glm::dvec3 normal = glm::normalize(receiver.normal);
    const double lift =
        receiver.lift < 0.0 ? scene_.clearance(receiver.position, normal) : receiver.lift;
    const glm::dvec3 origin = receiver.position + lift * normal;
    const glm::dmat3 basis = basisAbout(normal);
    RandomSequence random(seed_, index);
    const double count = double(cells_) * double(cells_);
    // Radiance over the density of both strategies together.
    const auto weighed = [&](const glm::dvec3& direction, const EnvironmentSampler::Sample& light) {
        const double cosine = glm::dot(normal, direction) / std::numbers::pi;
        if (!(cosine > 0.0) || light.radiance == glm::dvec3(0.0) ||
            scene_.occluded(origin, direction)) {
            return glm::dvec3(0.0);
        }
        return light.radiance * (cosine / (count * (cosine + light.density)));
    };
    std::array<glm::dvec3, 2> sums{glm::dvec3(0.0), glm::dvec3(0.0)};
    for (glm::dvec3& sum : sums) {
        for (int cell = 0; cell < cells_ * cells_; ++cell) {
            const auto place = [&] {
                const double x = random.next();
                return glm::dvec2(double(cell % cells_) + x,
                                  double(cell / cells_) + random.next()) /
                       double(cells_);
            };
            const glm::dvec3 direction = basis * cosineDirection(place());
            sum += weighed(direction, sampler_.at(direction));
            const EnvironmentSampler::Sample light = sampler_.sample(place());
            if (light.density > 0.0) {
                sum += weighed(light.direction, light);
            }
        }
    }
    return sums;
}

AoStatus check(const lighting::EnvironmentMap& map, std::span<const Receiver> receivers,
               const LightSettings& settings) {
    if (AoStatus status = lighting::checkEnvironment(map); !status) {
        return status;
    }
    if (settings.rays < 8 || settings.rays > mostLightRays || settings.threads < 0) {
        return {StatusCode::InvalidOption, "rays is " + std::to_string(settings.rays) +
                                               ", must be 8 to " + std::to_string(mostLightRays) +
                                               "; threads is " + std::to_string(settings.threads) +
                                               ", must be 0 or more"};
    }
    for (std::size_t i = 0; i < receivers.size(); ++i) {
        const glm::dvec3& position = receivers[i].position;
        const double size = glm::length(receivers[i].normal);
        if (!std::isfinite(position.x + position.y + position.z + receivers[i].lift)) {
            return {StatusCode::InvalidPosition,
                    "position or lift of receiver " + std::to_string(i) + " is not finite"};
        }
        if (!(size > 0.0) || !std::isfinite(size)) {
            return {StatusCode::InvalidNormal,
                    "normal of receiver " + std::to_string(i) + " is zero or not finite"};
        }
    }
    return {};
}

} // namespace

EnvironmentSampler::EnvironmentSampler(const lighting::EnvironmentMap& map) : map_(map) {
    rows_.reserve(static_cast<std::size_t>(map.height));
    columns_.reserve(map.radiance.size());
    double all = 0.0;
    for (int y = 0; y < map.height; ++y) {
        double row = 0.0;
        for (int x = 0; x < map.width; ++x) {
            row += brightness(map.radiance[columns_.size()]);
            columns_.push_back(row);
        }
        all += row * texelAngle(map, y);
        rows_.push_back(all);
    }
}

EnvironmentSampler::Sample EnvironmentSampler::texel(int x, int y,
                                                     const glm::dvec3& direction) const {
    const glm::vec3& radiance =
        map_.radiance[static_cast<std::size_t>(y) * static_cast<std::size_t>(map_.width) +
                      static_cast<std::size_t>(x)];
    const double all = rows_.back();
    return {direction, all > 0.0 ? brightness(radiance) / all : 0.0, glm::dvec3(radiance)};
}

EnvironmentSampler::Sample EnvironmentSampler::sample(const glm::dvec2& square) const {
    const auto width = static_cast<std::size_t>(map_.width);
    const auto [y, up] = find(rows_, square.y);
    const auto [x, along] =
        find(std::span(columns_).subspan(static_cast<std::size_t>(y) * width, width), square.x);
    // Within the row uniform in the sine of the latitude, which is uniform over the sphere.
    const double low = std::sin(std::numbers::pi * (double(y) / double(map_.height) - 0.5));
    const double high = std::sin(std::numbers::pi * (double(y + 1) / double(map_.height) - 0.5));
    const double sine = low + up * (high - low);
    const double level = std::sqrt(std::max(0.0, 1.0 - sine * sine));
    const double longitude =
        2.0 * std::numbers::pi * ((double(x) + along) / double(map_.width) - 0.5);
    return texel(x, y, {level * std::cos(longitude), sine, level * std::sin(longitude)});
}

EnvironmentSampler::Sample EnvironmentSampler::at(const glm::dvec3& direction) const {
    const double longitude = std::atan2(direction.z, direction.x) / (2.0 * std::numbers::pi) + 0.5;
    const double latitude = std::asin(std::clamp(direction.y, -1.0, 1.0)) / std::numbers::pi + 0.5;
    const int x = std::clamp(static_cast<int>(longitude * map_.width), 0, map_.width - 1);
    const int y = std::clamp(static_cast<int>(latitude * map_.height), 0, map_.height - 1);
    return texel(x, y, direction);
}

Result<LightList> traceEnvironment(const RayScene& scene, const lighting::EnvironmentMap& map,
                                   std::span<const Receiver> receivers,
                                   const LightSettings& settings, const LoopProgress& progress) {
    if (AoStatus status = check(map, receivers, settings); !status) {
        return status;
    }
    const LightTracer tracer(scene, map, settings);
    LightList list;
    list.radiance.assign(receivers.size(), glm::vec3(-1.0F));
    std::vector<double> squares(receivers.size(), 0.0);
    const auto body = [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const auto [first, second] = tracer.estimate(receivers[i], i);
            list.radiance[i] = glm::vec3(0.5 * (first + second));
            squares[i] = glm::dot(first - second, first - second) / 12.0;
        }
    };
    list.complete = parallelLoop(receivers.size(), settings.threads, body, progress);
    double sum = 0.0;
    for (const double square : squares) {
        sum += square;
    }
    list.noise = receivers.empty() ? 0.0 : std::sqrt(sum / double(receivers.size()));
    return list;
}

} // namespace aolib
