#include <aolib/lighting/EnvironmentMap.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "shared/lat_long.h"

namespace aolib::lighting {

namespace {

constexpr int mostTexels = 16384;

bool good(const glm::vec3& radiance) {
    for (int channel = 0; channel < 3; ++channel) {
        if (!(std::isfinite(radiance[channel]) && radiance[channel] >= 0.0F)) {
            return false;
        }
    }
    return true;
}

int cell(float place, int count) {
    return std::clamp(static_cast<int>(place * static_cast<float>(count)), 0, count - 1);
}

} // namespace

glm::vec2 latLong(const glm::vec3& direction) {
    return shared::latLongPlace(direction);
}

glm::vec3 latLongDirection(const glm::vec2& place) {
    return shared::latLongDirectionAt(place);
}

glm::vec3 radianceFrom(const EnvironmentMap& map, const glm::vec3& direction) {
    const glm::vec2 place = latLong(direction);
    const auto row = static_cast<std::size_t>(cell(place.y, map.height));
    const auto column = static_cast<std::size_t>(cell(place.x, map.width));
    return map.radiance[row * static_cast<std::size_t>(map.width) + column];
}

EnvironmentMap turned(const EnvironmentMap& map, float turn) {
    EnvironmentMap result = map;
    const float share = turn - std::floor(turn);
    const int shift =
        static_cast<int>(std::lround(share * static_cast<float>(map.width))) % map.width;
    for (int y = 0; y < map.height; ++y) {
        const auto row = result.radiance.begin() + std::ptrdiff_t{y} * map.width;
        std::rotate(row, row + (map.width - shift), row + map.width);
    }
    return result;
}

AoStatus checkEnvironment(const EnvironmentMap& map) {
    if (map.width < 1 || map.width > mostTexels || map.height < 1 || map.height > mostTexels) {
        return {StatusCode::InvalidOption, "an environment of " + std::to_string(map.width) +
                                               " x " + std::to_string(map.height) +
                                               " texels, must be 1 to 16384 each way"};
    }
    const auto width = static_cast<std::size_t>(map.width);
    const std::size_t texels = width * static_cast<std::size_t>(map.height);
    if (map.radiance.size() != texels) {
        return {StatusCode::InvalidOption, "an environment of " + std::to_string(map.width) +
                                               " x " + std::to_string(map.height) +
                                               " texels holds " +
                                               std::to_string(map.radiance.size()) + " values"};
    }
    const auto bad = std::find_if_not(map.radiance.begin(), map.radiance.end(), good);
    if (bad != map.radiance.end()) {
        const auto texel = static_cast<std::size_t>(bad - map.radiance.begin());
        return {StatusCode::InvalidOption, "the radiance of texel (" +
                                               std::to_string(texel % width) + ", " +
                                               std::to_string(texel / width) +
                                               ") of the environment is negative or not finite"};
    }
    return {};
}

} // namespace aolib::lighting
