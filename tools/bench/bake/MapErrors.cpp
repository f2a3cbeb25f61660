#include "bench/bake/MapErrors.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <glm/geometric.hpp>

namespace aolib::bench {

bool atSeam(const bake::BakedMap& map, int x, int y) {
    for (int v = std::max(0, y - 1); v <= std::min(map.height - 1, y + 1); ++v) {
        for (int u = std::max(0, x - 1); u <= std::min(map.width - 1, x + 1); ++u) {
            if (map.kind[static_cast<std::size_t>(v * map.width + u)] != bake::TexelKind::Inside) {
                return true;
            }
        }
    }
    return false;
}

std::vector<std::uint8_t> sampledTexels(const bake::BakedMap& map, int inside) {
    std::vector<std::uint8_t> wanted(map.kind.size(), 0);
    std::vector<std::size_t> left;
    for (int y = 0; y < map.height; ++y) {
        for (int x = 0; x < map.width; ++x) {
            const auto i = static_cast<std::size_t>(y * map.width + x);
            if (map.kind[i] == bake::TexelKind::Empty) {
                continue;
            }
            if (atSeam(map, x, y)) {
                wanted[i] = 1;
            } else {
                left.push_back(i);
            }
        }
    }
    // Knuth's algorithm S: each is taken with the share of those yet needed in those yet to come.
    std::mt19937 random;
    auto needed = static_cast<std::uint64_t>(inside);
    for (std::size_t k = 0; k < left.size() && needed > 0; ++k) {
        if (random() * std::uint64_t{left.size() - k} < needed << 32U) {
            wanted[left[k]] = 1;
            --needed;
        }
    }
    return wanted;
}

MapErrors errorsOf(const bake::BakedMap& map, const bake::BakedMap& truth) {
    MapErrors errors;
    double squares[2] = {0.0, 0.0};
    int counts[2] = {0, 0};
    double angles = 0.0;
    int angleCount = 0;
    for (int y = 0; y < map.height; ++y) {
        for (int x = 0; x < map.width; ++x) {
            const auto i = static_cast<std::size_t>(y * map.width + x);
            if (truth.kind[i] == bake::TexelKind::Empty || truth.visibility[i] < 0.0F) {
                continue;
            }
            const double w = double(truth.visibility[i]);
            const double error = double(map.visibility[i]) - w;
            const bool seam = atSeam(truth, x, y);
            squares[seam ? 1 : 0] += error * error;
            ++counts[seam ? 1 : 0];
            errors.bias += seam ? 0.0 : error;
            if (!seam && w > 0.1 && w < 0.9) {
                const double cosine = double(glm::dot(map.bentNormal[i], truth.bentNormal[i]));
                angles += std::acos(std::clamp(cosine, -1.0, 1.0)) * 180.0 / std::numbers::pi;
                ++angleCount;
            }
        }
    }
    errors.inside = std::sqrt(squares[0] / std::max(1, counts[0]));
    errors.seams = std::sqrt(squares[1] / std::max(1, counts[1]));
    errors.bias /= std::max(1, counts[0]);
    errors.bentAngle = angles / std::max(1, angleCount);
    errors.compared = counts[0] + counts[1];
    return errors;
}

} // namespace aolib::bench
