#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include <glm/vec2.hpp>

#include "bake/scatter/PointShape.h"

namespace aolib::bake {

/// What points are scattered into: a stack of maps, and the facet that each texel shows.
struct PointTarget {
    glm::ivec2 size{0};            ///< texels
    std::span<const float> facets; ///< row by row from the bottom

    /// Tells each texel that a point touches, if it shows the point's facet, and the share of the
    /// point that lies in it. Defined here, for it is what scattering's time goes into.
    /// @param visit  `void(std::size_t texel, float share)`
    template <typename Visit>
    void scatter(const glm::vec2& place, const PointShape& shape, const Visit& visit) const {
        const glm::vec2 low = place - 0.5F * shape.sides;
        const glm::vec2 high = place + 0.5F * shape.sides;
        const int left = std::max(static_cast<int>(low.x), 0);
        const int right = std::min(static_cast<int>(high.x), size.x - 1);
        const int bottom = std::max(static_cast<int>(low.y), 0);
        const int top = std::min(static_cast<int>(high.y), size.y - 1);
        const float perArea = 1.0F / (shape.sides.x * shape.sides.y);
        for (int y = bottom; y <= top; ++y) {
            const float along = std::min(high.y, float(y + 1)) - std::max(low.y, float(y));
            const std::size_t row = static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x);
            for (int x = left; x <= right; ++x) {
                const std::size_t texel = row + static_cast<std::size_t>(x);
                if (facets[texel] != shape.facet) {
                    continue;
                }
                const float across = std::min(high.x, float(x + 1)) - std::max(low.x, float(x));
                visit(texel, shape.sides.x > 0.0F ? across * along * perArea : 1.0F);
            }
        }
    }
};

} // namespace aolib::bake
