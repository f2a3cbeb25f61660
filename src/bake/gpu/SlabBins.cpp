#include "bake/gpu/SlabBins.h"

#include <algorithm>
#include <cmath>

namespace aolib::bake {

namespace {

/// So much beyond its slabs, as a share of all of them, a triangle may reach in GL's arithmetic.
constexpr float rounding = 1e-5F;

} // namespace

void SlabBins::begin(const Slabs& slabs) {
    coordinates_.resize(positions_.size());
    std::transform(positions_.begin(), positions_.end(), coordinates_.begin(),
                   [&](const glm::vec3& place) { return slabs.coordinate(place); });
    spans_.resize(corners_.size() / 3);
    const float margin = rounding * float(slabs.count());
    for (std::size_t i = 0; i < spans_.size(); ++i) {
        const float a = coordinates_[corners_[3 * i]];
        const float b = coordinates_[corners_[3 * i + 1]];
        const float c = coordinates_[corners_[3 * i + 2]];
        spans_[i] = {static_cast<std::int32_t>(std::floor(std::min({a, b, c}) - margin)),
                     static_cast<std::int32_t>(std::floor(std::max({a, b, c}) + margin))};
    }
    fill(0, 0);
}

void SlabBins::fill(int first, int last) {
    first_ = first;
    const auto bins = static_cast<std::size_t>(std::max(0, last - first));
    starts_.assign(bins + 1, 0);
    const auto each = [&](const auto& visit) {
        for (std::size_t i = 0; i < spans_.size() && bins > 0; ++i) {
            const int high = std::min(spans_[i].high, last - 1);
            for (int slab = std::max(spans_[i].low, first); slab <= high; ++slab) {
                visit(i, static_cast<std::size_t>(slab - first));
            }
        }
    };
    each([&](std::size_t, std::size_t bin) { ++starts_[bin + 1]; });
    for (std::size_t bin = 0; bin < bins; ++bin) {
        starts_[bin + 1] += starts_[bin];
    }
    numbers_.resize(starts_.back());
    indices_.resize(3 * numbers_.size());
    std::vector<std::size_t> next(starts_.begin(), starts_.end() - 1);
    each([&](std::size_t triangle, std::size_t bin) {
        const std::size_t place = next[bin]++;
        numbers_[place] = static_cast<std::uint32_t>(triangle);
        std::copy_n(corners_.begin() + static_cast<std::ptrdiff_t>(3 * triangle), 3,
                    indices_.begin() + static_cast<std::ptrdiff_t>(3 * place));
    });
}

TriangleRange SlabBins::bin(int slab) const {
    const auto number = static_cast<std::size_t>(slab - first_);
    if (slab < first_ || number + 1 >= starts_.size()) {
        return {};
    }
    return {starts_[number], starts_[number + 1] - starts_[number]};
}

} // namespace aolib::bake
