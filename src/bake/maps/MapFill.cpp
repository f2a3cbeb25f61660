#include "bake/maps/MapFill.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

namespace aolib::bake {

namespace {

/// A sum over texels that have a value.
struct Sum {
    float visibility = 0.0F;
    glm::vec3 bentNormal{0.0F};
    float count = 0.0F;

    void add(const Sum& other) {
        visibility += other.visibility;
        bentNormal += other.bentNormal;
        count += other.count;
    }
    Sum mean() const { return {visibility / count, bentNormal / count, 1.0F}; }
};

/// A square grid of sums, row by row.
struct Level {
    int width = 0;
    int height = 0;
    std::vector<Sum> sums;

    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(x);
    }
    const Sum& at(int x, int y) const { return sums[index(x, y)]; }
};

Sum sumAt(const BakedMap& map, std::size_t texel) {
    return map.visibility[texel] < 0.0F ? Sum{}
                                        : Sum{map.visibility[texel], map.bentNormal[texel], 1.0F};
}

void put(BakedMap& map, std::size_t texel, const Sum& sum) {
    const Sum mean = sum.mean();
    const float length = glm::length(mean.bentNormal);
    map.visibility[texel] = mean.visibility;
    map.bentNormal[texel] = length > 0.0F ? mean.bentNormal / length : glm::vec3(0.0F);
}

/// Calls `visit` with each of the up to eight texels about one.
template <typename Visit>
void aboutTexel(const BakedMap& map, std::size_t texel, const Visit& visit) {
    const int x = static_cast<int>(texel % static_cast<std::size_t>(map.width));
    const int y = static_cast<int>(texel / static_cast<std::size_t>(map.width));
    for (int v = std::max(0, y - 1); v <= std::min(map.height - 1, y + 1); ++v) {
        for (int u = std::max(0, x - 1); u <= std::min(map.width - 1, x + 1); ++u) {
            if (u != x || v != y) {
                visit(static_cast<std::size_t>(v) * static_cast<std::size_t>(map.width) +
                      static_cast<std::size_t>(u));
            }
        }
    }
}

Level halved(const Level& fine) {
    Level coarse{(fine.width + 1) / 2, (fine.height + 1) / 2, {}};
    coarse.sums.resize(static_cast<std::size_t>(coarse.width) *
                       static_cast<std::size_t>(coarse.height));
    for (int y = 0; y < fine.height; ++y) {
        for (int x = 0; x < fine.width; ++x) {
            coarse.sums[coarse.index(x / 2, y / 2)].add(fine.at(x, y));
        }
    }
    return coarse;
}

} // namespace

BakedMap emptyMap(const TexelRaster& raster) {
    BakedMap map;
    map.width = raster.width();
    map.height = raster.height();
    map.visibility.assign(raster.size(), -1.0F);
    map.bentNormal.assign(raster.size(), glm::vec3(0.0F));
    map.kind = raster.kinds();
    return map;
}

void setTexel(BakedMap& map, std::size_t texel, const glm::vec4& sum, double norm,
              const glm::dvec3& normal) {
    map.visibility[texel] = static_cast<float>(std::max(0.0, double{sum.w} * norm));
    const float length = glm::length(glm::vec3(sum));
    map.bentNormal[texel] = length > 0.0F ? glm::vec3(sum) / length : glm::vec3(normal);
}

void finish(BakedMap& map, const MapOptions& options) {
    dilate(map, options.padding);
    if (options.fill) {
        fillRest(map);
    }
}

void erode(BakedMap& map) {
    std::vector<std::size_t> outer;
    for (std::size_t i = 0; i < map.visibility.size(); ++i) {
        bool beside = false;
        aboutTexel(map, i, [&](std::size_t j) { beside = beside || map.visibility[j] < 0.0F; });
        if (beside && map.visibility[i] >= 0.0F) {
            outer.push_back(i);
        }
    }
    for (const std::size_t i : outer) {
        map.visibility[i] = -1.0F;
        map.bentNormal[i] = glm::vec3(0.0F);
    }
}

void dilate(BakedMap& map, int steps) {
    std::vector<std::pair<std::size_t, Sum>> found;
    for (int step = 0; step < steps; ++step) {
        found.clear();
        for (std::size_t i = 0; i < map.visibility.size(); ++i) {
            if (map.visibility[i] >= 0.0F) {
                continue;
            }
            Sum sum;
            aboutTexel(map, i, [&](std::size_t j) { sum.add(sumAt(map, j)); });
            if (sum.count > 0.0F) {
                found.emplace_back(i, sum);
            }
        }
        if (found.empty()) {
            return;
        }
        for (const auto& [texel, sum] : found) {
            put(map, texel, sum);
        }
    }
}

void fillRest(BakedMap& map) {
    std::vector<Level> levels(1);
    levels[0] = {map.width, map.height, std::vector<Sum>(map.visibility.size())};
    for (std::size_t i = 0; i < map.visibility.size(); ++i) {
        levels[0].sums[i] = sumAt(map, i);
    }
    while (levels.back().sums.size() > 1) {
        levels.push_back(halved(levels.back()));
    }
    if (levels.back().sums[0].count == 0.0F) {
        return;
    }
    for (std::size_t i = 0; i < map.visibility.size(); ++i) {
        int x = static_cast<int>(i % static_cast<std::size_t>(map.width));
        int y = static_cast<int>(i / static_cast<std::size_t>(map.width));
        std::size_t level = 0;
        while (levels[level].at(x, y).count == 0.0F) {
            x /= 2;
            y /= 2;
            ++level;
        }
        if (level > 0) {
            put(map, i, levels[level].at(x, y));
        }
    }
}

} // namespace aolib::bake
