#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace aolib::bench {

/// A triangle cut into `splits` parts along each edge. Grid point (i, j), i + j <= splits, has the
/// barycentric weights u = i / splits and v = j / splits.
struct TriangleGrid {
    std::uint32_t splits = 1;

    std::size_t points() const {
        const std::size_t n = splits;
        return (n + 1) * (n + 2) / 2;
    }
    /// Row by row of j.
    std::size_t index(std::uint32_t i, std::uint32_t j) const {
        const std::size_t n = splits;
        return std::size_t{j} * (2 * n + 3 - j) / 2 + i;
    }

    /// The small triangle that a point lies in.
    struct Place {
        std::array<std::size_t, 3> corners{}; ///< indices of grid points
        std::array<double, 3> weights{};
    };
    Place locate(double u, double v) const {
        const double n = splits;
        const double x = std::clamp(u, 0.0, 1.0) * n;
        const double y = std::clamp(v, 0.0, 1.0) * n;
        const auto j = std::min(static_cast<std::uint32_t>(y), splits - 1);
        const auto i = std::min(static_cast<std::uint32_t>(x), splits - 1 - j);
        const double a = std::min(x - double(i), 1.0);
        const double b = std::min(y - double(j), 1.0);
        if (a + b <= 1.0 || i + j + 1 == splits) {
            return {{index(i, j), index(i + 1, j), index(i, j + 1)}, {1.0 - a - b, a, b}};
        }
        return {{index(i + 1, j + 1), index(i, j + 1), index(i + 1, j)},
                {a + b - 1.0, 1.0 - a, 1.0 - b}};
    }
};

} // namespace aolib::bench
