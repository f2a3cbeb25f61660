#include "lighting/Reduced.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

namespace aolib::lighting {

namespace {

/// The share of the sphere that a row has, by its number.
float rowWeight(int row, int rows) {
    const auto sineAt = [&](int edge) {
        return std::sin(std::numbers::pi * (double(edge) / double(rows) - 0.5));
    };
    return static_cast<float>(0.5 * (sineAt(row + 1) - sineAt(row)));
}

/// The texels of a row (or column) of `from` that texel `index` of `to` covers.
struct Covered {
    Covered(int index, int from, int to)
        : low(double(index) * from / to), high(double(index + 1) * from / to),
          first(static_cast<int>(low)), end(std::min(static_cast<int>(std::ceil(high)), from)) {}

    /// How much of a texel is covered.
    float share(int texel) const {
        return static_cast<float>(std::min(high, texel + 1.0) - std::max(low, double(texel)));
    }

    double low;
    double high;
    int first;
    int end; ///< the one behind the last
};

} // namespace

EnvironmentMap halved(const EnvironmentMap& map) {
    EnvironmentMap half;
    half.width = std::max(map.width / 2, 1);
    half.height = std::max(map.height / 2, 1);
    half.radiance.reserve(static_cast<std::size_t>(half.width) *
                          static_cast<std::size_t>(half.height));
    for (int y = 0; y < half.height; ++y) {
        const Covered rows(y, map.height, half.height);
        for (int x = 0; x < half.width; ++x) {
            const Covered columns(x, map.width, half.width);
            glm::vec3 sum(0.0F);
            float weights = 0.0F;
            for (int row = rows.first; row < rows.end; ++row) {
                for (int column = columns.first; column < columns.end; ++column) {
                    const float weight =
                        rows.share(row) * columns.share(column) * rowWeight(row, map.height);
                    sum += weight * map.radiance[static_cast<std::size_t>(row) *
                                                     static_cast<std::size_t>(map.width) +
                                                 static_cast<std::size_t>(column)];
                    weights += weight;
                }
            }
            half.radiance.push_back(sum / weights);
        }
    }
    return half;
}

EnvironmentMap reduced(EnvironmentMap map, int rows) {
    while (map.height > rows) {
        map = halved(map);
    }
    return map;
}

} // namespace aolib::lighting
