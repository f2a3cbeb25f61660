#include "content/generated/Environments.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec3.hpp>

namespace aolib {

namespace {

constexpr int columns = 512;
constexpr int rows = 256;
/// Wide enough to cover several texels: the real one, of 0.27 degrees, would fall into one.
const float sunRadius = glm::radians(1.5F);

template <typename Radiance>
lighting::EnvironmentMap mapOf(const Radiance& radiance) {
    lighting::EnvironmentMap map;
    map.width = columns;
    map.height = rows;
    map.radiance.reserve(std::size_t{columns} * rows);
    for (int y = 0; y < rows; ++y) {
        for (int x = 0; x < columns; ++x) {
            map.radiance.push_back(radiance(lighting::latLongDirection(
                {(float(x) + 0.5F) / float(columns), (float(y) + 0.5F) / float(rows)})));
        }
    }
    return map;
}

/// Blue above, whitish at the horizon, dull ground below.
glm::vec3 clearSky(const glm::vec3& direction) {
    const glm::vec3 zenith(0.25F, 0.45F, 0.90F);
    const glm::vec3 horizon(0.90F, 0.95F, 1.00F);
    const glm::vec3 ground(0.12F, 0.11F, 0.10F);
    return direction.y < 0.0F ? ground : glm::mix(horizon, zenith, std::sqrt(direction.y));
}

/// A disc of even brightness.
/// @param irradiance  on a surface that faces it.
glm::vec3 disc(const glm::vec3& direction, float elevation, float longitude,
               const glm::vec3& irradiance) {
    const float up = glm::radians(elevation);
    const float along = glm::radians(longitude);
    const glm::vec3 towards(std::cos(up) * std::cos(along), std::sin(up),
                            std::cos(up) * std::sin(along));
    const float edge = std::cos(sunRadius);
    const float solidAngle = 2.0F * std::numbers::pi_v<float> * (1.0F - edge);
    return glm::dot(direction, towards) > edge ? irradiance / solidAngle : glm::vec3(0.0F);
}

/// Radiance where a ray meets a rectangle that faces it from `centre`, half as wide and high as
/// said, both per unit of distance.
glm::vec3 softbox(const glm::vec3& direction, const glm::vec3& centre, float halfWidth,
                  float halfHeight, const glm::vec3& radiance) {
    const glm::vec3 forward = glm::normalize(centre);
    const glm::vec3 right = glm::normalize(glm::cross(forward, glm::vec3(0.0F, 1.0F, 0.0F)));
    const glm::vec3 up = glm::cross(right, forward);
    const float depth = glm::dot(direction, forward);
    if (depth <= 0.0F) {
        return glm::vec3(0.0F);
    }
    const glm::vec3 at = direction / depth;
    return std::abs(glm::dot(at, right)) < halfWidth && std::abs(glm::dot(at, up)) < halfHeight
               ? radiance
               : glm::vec3(0.0F);
}

lighting::EnvironmentMap buildSunny() {
    return mapOf([](const glm::vec3& d) {
        return clearSky(d) + disc(d, 40.0F, 60.0F, glm::vec3(4.0F, 3.8F, 3.4F));
    });
}

lighting::EnvironmentMap buildSunset() {
    return mapOf([](const glm::vec3& d) {
        const float nearSun = std::max(0.0F, d.x * -0.5F + d.z * 0.87F);
        const glm::vec3 glow = d.y < 0.0F
                                   ? glm::vec3(0.0F)
                                   : glm::vec3(0.9F, 0.4F, 0.1F) * nearSun * std::exp(-5.0F * d.y);
        return 0.6F * clearSky(d) + glow + disc(d, 10.0F, 120.0F, glm::vec3(2.4F, 1.5F, 0.7F));
    });
}

/// The overcast sky of the CIE: three times as bright at the zenith as at the horizon.
lighting::EnvironmentMap buildOvercast() {
    return mapOf([](const glm::vec3& d) {
        return d.y < 0.0F ? glm::vec3(0.1F) : glm::vec3((1.0F + 2.0F * d.y) / 3.0F);
    });
}

lighting::EnvironmentMap buildStudio() {
    return mapOf([](const glm::vec3& d) {
        return glm::vec3(0.05F) + softbox(d, {1.0F, 0.8F, 0.6F}, 0.5F, 0.5F, {6.0F, 5.5F, 5.0F}) +
               softbox(d, {-1.0F, 0.4F, 0.8F}, 0.3F, 0.6F, {2.0F, 2.4F, 3.0F}) +
               softbox(d, {0.0F, 1.0F, -0.2F}, 0.9F, 0.2F, glm::vec3(2.0F));
    });
}

lighting::EnvironmentMap buildWindow() {
    return mapOf([](const glm::vec3& d) {
        return glm::vec3(0.04F, 0.035F, 0.03F) +
               softbox(d, {1.0F, 0.45F, 0.2F}, 0.45F, 0.5F, {8.0F, 9.0F, 10.0F});
    });
}

} // namespace

const std::vector<GeneratedEnvironment>& generatedEnvironments() {
    static const std::vector<GeneratedEnvironment> environments{
        {"sunny", "a strong sun at 40 degrees in a clear sky", buildSunny},
        {"sunset", "a sun at 10 degrees, a glow about it", buildSunset},
        {"overcast", "the overcast sky of the CIE", buildOvercast},
        {"studio", "three softboxes in the dark", buildStudio},
        {"window", "a dark room with one bright window", buildWindow},
    };
    return environments;
}

const GeneratedEnvironment* findGeneratedEnvironment(std::string_view name) {
    const std::vector<GeneratedEnvironment>& all = generatedEnvironments();
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&](const GeneratedEnvironment& e) { return name == e.name; });
    return found == all.end() ? nullptr : &*found;
}

} // namespace aolib
