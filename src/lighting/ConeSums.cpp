#include "lighting/ConeSums.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/common.hpp>

namespace aolib::lighting {

namespace {

using std::numbers::pi;

} // namespace

ConeSums::ConeSums(const EnvironmentMap& map) : map_(map) {
    const auto width = static_cast<std::size_t>(map.width);
    std::vector<glm::dvec2> directions;
    for (std::size_t x = 0; x < width; ++x) {
        const double longitude = 2.0 * pi * ((double(x) + 0.5) / double(width) - 0.5);
        directions.emplace_back(std::cos(longitude), std::sin(longitude));
    }
    sums_.reserve((width + 1) * static_cast<std::size_t>(map.height));
    for (int y = 0; y < map.height; ++y) {
        const double low = std::sin(pi * (double(y) / double(map.height) - 0.5));
        const double high = std::sin(pi * (double(y + 1) / double(map.height) - 0.5));
        const double latitude = pi * ((double(y) + 0.5) / double(map.height) - 0.5);
        rows_.push_back(
            {std::sin(latitude), std::cos(latitude), 2.0 * pi / double(width) * (high - low)});
        Moments sum;
        sums_.push_back(sum);
        for (std::size_t x = 0; x < width; ++x) {
            const glm::vec3& radiance = map.radiance[static_cast<std::size_t>(y) * width + x];
            const glm::dvec4 value(radiance, 1.0);
            sum.plain += value;
            sum.cosine += directions[x].x * value;
            sum.sine += directions[x].y * value;
            sums_.push_back(sum);
        }
    }
}

ConeSums::Moments ConeSums::upTo(std::size_t row, double place) const {
    const auto width = static_cast<std::size_t>(map_.width);
    const Moments* sums = sums_.data() + row * (width + 1);
    const double turns = std::floor(place / double(width));
    const double within = place - turns * double(width);
    const std::size_t texel = std::min(static_cast<std::size_t>(within), width - 1);
    const double part = within - double(texel);
    const auto at = [&](glm::dvec4 Moments::*member) {
        const glm::dvec4& before = sums[texel].*member;
        return turns * (sums[width].*member) + before + part * (sums[texel + 1].*member - before);
    };
    return {at(&Moments::plain), at(&Moments::cosine), at(&Moments::sine)};
}

ConeSums::Moments ConeSums::between(std::size_t row, double from, double to) const {
    const Moments first = upTo(row, from);
    const Moments last = upTo(row, to);
    return {last.plain - first.plain, last.cosine - first.cosine, last.sine - first.sine};
}

glm::vec3 ConeSums::mean(const glm::dvec3& axis, double cosine) const {
    const double level = std::hypot(axis.x, axis.z);
    const double longitude = std::atan2(axis.z, axis.x);
    const double width = double(map_.width);
    const double middle = (longitude / (2.0 * pi) + 0.5) * width;
    glm::dvec4 sum(0.0); // radiance and weight
    for (std::size_t y = 0; y < rows_.size(); ++y) {
        const Row& row = rows_[y];
        const double straight =
            axis.y * row.sine; // the cosine is this, and `around` times a cosine
        const double around = level * row.level;
        const double limit = cosine - straight;
        if (limit >= around) {
            continue;
        }
        const double reach = limit <= -around ? pi : std::acos(limit / around);
        const double texels = reach / (2.0 * pi) * width;
        const Moments moments = between(y, middle - texels, middle + texels);
        sum += row.angle * (straight * moments.plain +
                            row.level * (axis.x * moments.cosine + axis.z * moments.sine));
    }
    if (!(sum.w > 0.0)) {
        return radianceFrom(map_, glm::vec3(axis));
    }
    return glm::max(glm::vec3(glm::dvec3(sum) / sum.w), glm::vec3(0.0F));
}

} // namespace aolib::lighting
