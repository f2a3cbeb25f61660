#include "image/Ssim.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace aolib {

namespace {

constexpr int windowSize = 11;
constexpr double deviation = 1.5;
constexpr double c1 = 0.01 * 0.01;
constexpr double c2 = 0.03 * 0.03;

/// Weighted sums over a window, or over one row of it.
struct Moments {
    double a = 0.0;
    double b = 0.0;
    double aa = 0.0;
    double bb = 0.0;
    double ab = 0.0;
    bool whole = true; ///< no background

    void add(const Moments& other, double weight) {
        a += weight * other.a;
        b += weight * other.b;
        aa += weight * other.aa;
        bb += weight * other.bb;
        ab += weight * other.ab;
        whole = whole && other.whole;
    }
};

using Window = std::array<double, windowSize>;

Window gaussian() {
    Window weights{};
    double sum = 0.0;
    for (int i = 0; i < windowSize; ++i) {
        const double x = (i - windowSize / 2) / deviation;
        weights[static_cast<std::size_t>(i)] = std::exp(-0.5 * x * x);
        sum += weights[static_cast<std::size_t>(i)];
    }
    for (double& weight : weights) {
        weight /= sum;
    }
    return weights;
}

Moments pixelMoments(float a, float b) {
    const double x = double{a};
    const double y = double{b};
    return {x, y, x * x, y * y, x * y, a != backgroundValue && b != backgroundValue};
}

/// The Gaussian is separable: first along a row, one result per window's left edge.
std::vector<Moments> rowMoments(const FloatImage& a, const FloatImage& b, int y,
                                const Window& weights) {
    std::vector<Moments> row(static_cast<std::size_t>(a.width - windowSize + 1));
    for (std::size_t x = 0; x < row.size(); ++x) {
        for (std::size_t i = 0; i < weights.size(); ++i) {
            const int column = static_cast<int>(x + i);
            row[x].add(pixelMoments(a.at(column, y), b.at(column, y)), weights[i]);
        }
    }
    return row;
}

double similarity(const Moments& m) {
    const double varianceA = m.aa - m.a * m.a;
    const double varianceB = m.bb - m.b * m.b;
    const double covariance = m.ab - m.a * m.b;
    return (2.0 * m.a * m.b + c1) * (2.0 * covariance + c2) /
           ((m.a * m.a + m.b * m.b + c1) * (varianceA + varianceB + c2));
}

} // namespace

std::optional<double> meanSsim(const FloatImage& a, const FloatImage& b) {
    if (a.width < windowSize || a.height < windowSize) {
        return std::nullopt;
    }
    const Window weights = gaussian();
    std::array<std::vector<Moments>, windowSize> rows; // a ring: row y lies at y % windowSize
    double sum = 0.0;
    std::size_t count = 0;
    for (int y = 0; y < a.height; ++y) {
        rows[static_cast<std::size_t>(y % windowSize)] = rowMoments(a, b, y, weights);
        if (y < windowSize - 1) {
            continue;
        }
        for (std::size_t x = 0; x < rows[0].size(); ++x) {
            Moments window;
            for (int i = 0; i < windowSize; ++i) {
                const int row = (y - (windowSize - 1) + i) % windowSize;
                window.add(rows[static_cast<std::size_t>(row)][x],
                           weights[static_cast<std::size_t>(i)]);
            }
            if (window.whole) {
                sum += similarity(window);
                ++count;
            }
        }
    }
    return count == 0 ? std::nullopt : std::optional(sum / static_cast<double>(count));
}

} // namespace aolib
