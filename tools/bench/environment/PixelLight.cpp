#include "bench/environment/PixelLight.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include <glm/geometric.hpp>

#include <aolib/lighting/ConeTable.h>
#include <aolib/lighting/SectorTable.h>
#include <aolib/lighting/Sun.h>

namespace aolib::bench {

namespace {

/// Boxes of a map by sums over its rows and columns: what blurring by mipmaps comes near to.
class BoxSums {
public:
    explicit BoxSums(const lighting::EnvironmentMap& map)
        : width_(static_cast<std::size_t>(map.width)),
          height_(static_cast<std::size_t>(map.height)), sums_((width_ + 1) * (height_ + 1)) {
        for (std::size_t y = 0; y < height_; ++y) {
            glm::dvec3 row(0.0);
            for (std::size_t x = 0; x < width_; ++x) {
                row += glm::dvec3(map.radiance[y * width_ + x]);
                at(x + 1, y + 1) = row + at(x + 1, y);
            }
        }
    }

    /// The mean over a square of `width` shares of the map about `place`; it wraps along u and
    /// ends at the poles.
    glm::vec3 mean(const glm::vec2& place, float width) const {
        const double half = 0.5 * double(std::clamp(width, 1e-3F, 1.0F));
        const double low = std::max(0.0, double{place.y} - half);
        const double high = std::min(1.0, double{place.y} + half);
        const double left = double{place.x} - half;
        const double right = double{place.x} + half;
        const glm::dvec3 sum =
            upTo(right, high) - upTo(left, high) - upTo(right, low) + upTo(left, low);
        const double texels = double(width_) * double(height_);
        return glm::vec3(sum / ((right - left) * (high - low) * texels));
    }

private:
    glm::dvec3& at(std::size_t x, std::size_t y) { return sums_[y * (width_ + 1) + x]; }
    const glm::dvec3& at(std::size_t x, std::size_t y) const { return sums_[y * (width_ + 1) + x]; }

    /// Over all that is to the left of and below a place.
    glm::dvec3 upTo(double u, double v) const {
        const double turns = std::floor(u);
        const double x = (u - turns) * double(width_);
        const double y = v * double(height_);
        const std::size_t column = std::min(static_cast<std::size_t>(x), width_ - 1);
        const std::size_t row = std::min(static_cast<std::size_t>(y), height_ - 1);
        const double right = x - double(column);
        const double up = y - double(row);
        const auto along = [&](std::size_t from) {
            return (1.0 - up) * at(from, row) + up * at(from, row + 1);
        };
        return turns * along(width_) + (1.0 - right) * along(column) + right * along(column + 1);
    }

    std::size_t width_;
    std::size_t height_;
    std::vector<glm::dvec3> sums_;
};

glm::vec3 sunAt(const RayScene& scene, const Receiver& receiver, const lighting::Sun& sun) {
    const glm::dvec3 towards(sun.direction);
    if (glm::dot(receiver.normal, towards) <= 0.0) {
        return glm::vec3(0.0F);
    }
    const double lift =
        receiver.lift < 0.0 ? scene.clearance(receiver.position, receiver.normal) : receiver.lift;
    const bool hidden = scene.occluded(receiver.position + lift * receiver.normal, towards);
    return hidden ? glm::vec3(0.0F) : lighting::sunLight(sun, glm::vec3(receiver.normal));
}

} // namespace

Result<std::vector<glm::vec3>> lightOf(const RayScene& scene, std::span<const Receiver> receivers,
                                       std::span<const Opening> openings,
                                       const lighting::EnvironmentMap& map,
                                       host::LitMethod method) {
    using host::LitMethod;
    lighting::SplitEnvironment split{std::nullopt, map};
    if (method == LitMethod::ConeAndSun || method == LitMethod::SectorsAndSun) {
        split = lighting::splitSun(map);
    }
    const Result<lighting::ConeTable> cones = lighting::ConeTable::create(split.rest);
    if (!cones) {
        return cones.status();
    }
    const Result<lighting::SectorTable> sectors = lighting::SectorTable::create(split.rest);
    if (!sectors) {
        return sectors.status();
    }
    const BoxSums boxes(map);
    std::vector<glm::vec3> light(receivers.size());
    for (std::size_t i = 0; i < receivers.size(); ++i) {
        const Opening& opening = openings[i];
        const glm::vec3 normal(receivers[i].normal);
        switch (method) {
        case LitMethod::Irradiance:
            light[i] = opening.visibility * cones->lookup(normal, 1.0F);
            break;
        case LitMethod::Blurred:
        case LitMethod::BlurredByAngles:
            light[i] = opening.share == 0.0F
                           ? glm::vec3(0.0F)
                           : opening.share * boxes.mean(lighting::latLong(opening.meanDirection),
                                                        std::sqrt(opening.share));
            break;
        case LitMethod::Cone:
        case LitMethod::ConeAndSun:
            light[i] =
                opening.visibility == 0.0F
                    ? glm::vec3(0.0F)
                    : lighting::coneLight(*cones, normal, opening.bentNormal, opening.visibility);
            break;
        case LitMethod::Sectors:
        case LitMethod::SectorsAndSun:
            light[i] = lighting::sectorLight(*sectors, normal, opening.sectors);
            break;
        }
        if (split.sun) {
            light[i] += sunAt(scene, receivers[i], *split.sun);
        }
    }
    return light;
}

} // namespace aolib::bench
