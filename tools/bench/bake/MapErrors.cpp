#include "bench/bake/MapErrors.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace aolib::bench {

namespace {

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

} // namespace

MapErrors errorsOf(const bake::BakedMap& map, const bake::BakedMap& truth) {
    MapErrors errors;
    double squares[2] = {0.0, 0.0};
    int counts[2] = {0, 0};
    double angles = 0.0;
    int angleCount = 0;
    for (int y = 0; y < map.height; ++y) {
        for (int x = 0; x < map.width; ++x) {
            const auto i = static_cast<std::size_t>(y * map.width + x);
            if (truth.kind[i] == bake::TexelKind::Empty) {
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
