#include <aolib/lighting/Sun.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace aolib::lighting {

namespace {

using std::numbers::pi;

const double nearCosine = std::cos(glm::radians(5.0)); ///< what belongs to a sun
const double ringCosine = std::cos(glm::radians(8.0)); ///< and what lies about it
constexpr float edgeBrightness = 0.1F;                 ///< of the brightest texel's
constexpr double leastShare = 0.2;                     ///< of all light

float brightness(const glm::vec3& radiance) {
    return (radiance.r + radiance.g + radiance.b) / 3.0F;
}

/// A texel of the map.
struct Texel {
    std::size_t index = 0;
    glm::dvec3 direction{0.0};
    double angle = 0.0; ///< steradians
};

std::vector<Texel> texelsOf(const EnvironmentMap& map) {
    std::vector<Texel> texels;
    texels.reserve(map.radiance.size());
    for (int y = 0; y < map.height; ++y) {
        const double low = std::sin(pi * (double(y) / double(map.height) - 0.5));
        const double high = std::sin(pi * (double(y + 1) / double(map.height) - 0.5));
        for (int x = 0; x < map.width; ++x) {
            const glm::vec2 place{(static_cast<float>(x) + 0.5F) / static_cast<float>(map.width),
                                  (static_cast<float>(y) + 0.5F) / static_cast<float>(map.height)};
            texels.push_back({texels.size(), glm::dvec3(latLongDirection(place)),
                              2.0 * pi / double(map.width) * (high - low)});
        }
    }
    return texels;
}

} // namespace

SplitEnvironment splitSun(EnvironmentMap map) {
    SplitEnvironment split{std::nullopt, std::move(map)};
    std::vector<glm::vec3>& radiance = split.rest.radiance;
    const auto brightest = std::max_element(
        radiance.begin(), radiance.end(),
        [](const glm::vec3& a, const glm::vec3& b) { return brightness(a) < brightness(b); });
    const std::vector<Texel> texels = texelsOf(split.rest);
    const Texel& peak = texels[static_cast<std::size_t>(brightest - radiance.begin())];
    const float edge = edgeBrightness * brightness(*brightest);

    std::vector<Texel> disc;
    glm::dvec3 ring(0.0);
    double ringAngle = 0.0;
    double all = 0.0;
    bool wider = false; // as bright beyond what a sun may be
    for (const Texel& texel : texels) {
        const double cosine = glm::dot(texel.direction, peak.direction);
        const bool bright = brightness(radiance[texel.index]) >= edge;
        all += texel.angle * double{brightness(radiance[texel.index])};
        if (cosine >= nearCosine && bright) {
            disc.push_back(texel);
        } else if (cosine >= ringCosine) {
            wider = wider || bright;
            ring += texel.angle * glm::dvec3(radiance[texel.index]);
            ringAngle += texel.angle;
        }
    }
    if (!(all > 0.0) || wider || !(ringAngle > 0.0)) {
        return split;
    }
    const glm::dvec3 about = ring / ringAngle;
    glm::dvec3 direction(0.0);
    glm::dvec3 irradiance(0.0);
    double angle = 0.0;
    for (const Texel& texel : disc) {
        const glm::dvec3 light =
            texel.angle * glm::max(glm::dvec3(radiance[texel.index]) - about, glm::dvec3(0.0));
        irradiance += light;
        direction += (light.r + light.g + light.b) * texel.direction;
        angle += texel.angle;
    }
    if ((irradiance.r + irradiance.g + irradiance.b) / 3.0 < leastShare * all) {
        return split;
    }
    for (const Texel& texel : disc) {
        radiance[texel.index] = glm::min(radiance[texel.index], glm::vec3(about));
    }
    split.sun = Sun{glm::vec3(glm::normalize(direction)), glm::vec3(irradiance),
                    static_cast<float>(std::acos(1.0 - angle / (2.0 * pi)))};
    return split;
}

glm::vec3 sunLight(const Sun& sun, const glm::vec3& normal) {
    const float cosine = std::max(glm::dot(sun.direction, normal), 0.0F);
    return sun.irradiance * (cosine / static_cast<float>(pi));
}

} // namespace aolib::lighting
