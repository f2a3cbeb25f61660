#include <aolib/bake/Atlas.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <new>
#include <numeric>
#include <string>
#include <unordered_map>

#include <glm/common.hpp>

#include "bake/atlas/AtlasCharts.h"

namespace aolib::bake {

namespace {

/// Halvings of the range in which the best scale is looked for.
constexpr int searchSteps = 24;

/// Where charts of one scale go, lower left corners, texels; empty where they do not fit.
class Packing {
public:
    Packing(const std::vector<AtlasChart>& charts, int width, int height, int gap)
        : charts_(charts), width_(width), height_(height), gap_(gap),
          block_(static_cast<int>(std::bit_floor(static_cast<unsigned>(std::max(gap, 1))))),
          order_(charts.size()) {
        std::iota(order_.begin(), order_.end(), std::size_t{0});
        std::stable_sort(order_.begin(), order_.end(), [&](std::size_t a, std::size_t b) {
            return charts[a].size.y > charts[b].size.y;
        });
    }

    /// @param scale  texels per world unit.
    std::vector<glm::ivec2> at(float scale) const {
        std::vector<glm::ivec2> places(charts_.size());
        glm::ivec2 next(0);
        int rowHeight = 0;
        for (const std::size_t i : order_) {
            const auto block = static_cast<float>(block_);
            const glm::vec2 wanted =
                glm::ceil((charts_[i].size * scale + float(gap_)) / block) * block;
            if (!(wanted.x <= float(width_) && wanted.y <= float(height_))) {
                return {};
            }
            const glm::ivec2 size(wanted);
            if (next.x + size.x > width_) {
                next = {0, next.y + rowHeight};
                rowHeight = 0;
            }
            rowHeight = std::max(rowHeight, size.y);
            if (next.y + rowHeight > height_) {
                return {};
            }
            places[i] = next;
            next.x += size.x;
        }
        return places;
    }

private:
    const std::vector<AtlasChart>& charts_;
    int width_;
    int height_;
    int gap_;
    int block_; ///< charts' places are squares of this edge, texels, and theirs alone
    std::vector<std::size_t> order_; ///< tallest first
};

UnwrappedSurface unwrapped(const Surface& surface, std::size_t number,
                           const std::vector<AtlasChart>& charts,
                           const std::vector<std::vector<glm::vec2>>& chartUvs) {
    UnwrappedSurface result;
    result.indices.assign(surface.indices.size(), 0);
    std::vector<bool> placed(surface.indices.size(), false);
    const auto add = [&](std::uint32_t vertex, const glm::vec2& uv) {
        result.source.push_back(vertex);
        result.uvs.push_back(uv);
        return static_cast<std::uint32_t>(result.source.size() - 1);
    };
    for (std::size_t c = 0; c < charts.size(); ++c) {
        if (charts[c].surface != number) {
            continue;
        }
        std::unordered_map<std::uint32_t, std::uint32_t> known;
        for (std::size_t i = 0; i < charts[c].corners.size(); ++i) {
            const std::size_t corner = std::size_t{charts[c].triangles[i / 3]} * 3 + i % 3;
            const std::uint32_t vertex = surface.indices[corner];
            const auto [found, fresh] = known.try_emplace(vertex, 0U);
            if (fresh) {
                found->second = add(vertex, chartUvs[c][i]);
            }
            result.indices[corner] = found->second;
            placed[corner] = true;
        }
    }
    for (std::size_t corner = 0; corner < placed.size(); ++corner) {
        if (!placed[corner]) { // of a triangle without area: anywhere will do
            result.indices[corner] = add(surface.indices[corner], glm::vec2(0.0F));
        }
    }
    return result;
}

} // namespace

Result<Atlas> makeAtlas(const std::vector<const Surface*>& surfaces, int width, int height,
                        int gap) try {
    std::vector<AtlasChart> charts;
    Atlas atlas;
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        std::vector<AtlasChart> cut = cutCharts(*surfaces[i], i);
        std::move(cut.begin(), cut.end(), std::back_inserter(charts));
    }
    float longest = 0.0F;
    float area = 0.0F;
    for (const AtlasChart& chart : charts) {
        longest = std::max(longest, chart.size.x);
        area += chart.area;
    }
    const Packing packing(charts, width, height, gap);
    float low = 0.0F;
    float high = longest > 0.0F ? static_cast<float>(std::max(width, height)) / longest : 1.0F;
    std::vector<glm::ivec2> places = packing.at(low);
    if (places.size() != charts.size()) {
        return AoStatus(StatusCode::InvalidOption,
                        std::to_string(charts.size()) + " charts with gaps of " +
                            std::to_string(gap) + " texels do not fit into a map of " +
                            std::to_string(width) + " x " + std::to_string(height));
    }
    for (int step = 0; step < searchSteps; ++step) {
        const float middle = 0.5F * (low + high);
        std::vector<glm::ivec2> found = packing.at(middle);
        const bool fits = found.size() == charts.size();
        (fits ? low : high) = middle;
        if (fits) {
            places = std::move(found);
        }
    }
    const glm::vec2 size(width, height);
    std::vector<std::vector<glm::vec2>> uvs(charts.size());
    for (std::size_t c = 0; c < charts.size(); ++c) {
        for (const glm::vec2& p : charts[c].corners) {
            uvs[c].push_back((glm::vec2(places[c]) + 0.5F * float(gap) + p * low) / size);
        }
    }
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        atlas.surfaces.push_back(unwrapped(*surfaces[i], i, charts, uvs));
    }
    atlas.charts = charts.size();
    atlas.usedShare = double{area} * double{low} * double{low} / (double(width) * double(height));
    return atlas;
} catch (const std::bad_alloc&) {
    return AoStatus(StatusCode::OutOfMemory, "no memory left for an atlas");
}

Surface withAtlas(const Surface& surface, const UnwrappedSurface& unwrapped) {
    Surface result;
    result.map = surface.map;
    result.uvs = unwrapped.uvs;
    result.indices = unwrapped.indices;
    for (const std::uint32_t vertex : unwrapped.source) {
        result.positions.push_back(surface.positions[vertex]);
        if (!surface.normals.empty()) {
            result.normals.push_back(surface.normals[vertex]);
        }
    }
    return result;
}

} // namespace aolib::bake
