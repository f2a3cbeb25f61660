#include "viewer/TruthAverage.h"

#include <algorithm>
#include <cmath>

namespace aolib::viewer {

namespace {

/// A tracer's rays come as two grids of so many cells along each side, at most.
constexpr int kMostCells = 4;

} // namespace

void TruthAverage::clear() {
    *this = TruthAverage();
}

void TruthAverage::add(const Picture& picture, int rays) {
    if (rays_ == 0) {
        width_ = picture.width;
        height_ = picture.height;
        sums_.assign(picture.visibility.size(), 0.0);
        variances_.assign(picture.visibility.size(), 0.0);
    }
    const double weight = rays;
    for (std::size_t i = 0; i < sums_.size(); ++i) {
        const double error = weight * static_cast<double>(picture.standardError[i]);
        sums_[i] += weight * static_cast<double>(picture.visibility[i]);
        variances_[i] += error * error;
    }
    rays_ += rays;
}

FloatImage TruthAverage::visibility() const {
    FloatImage image(width_, height_, 1, backgroundValue);
    for (std::size_t i = 0; i < sums_.size(); ++i) {
        if (sums_[i] >= 0.0) {
            image.pixels[i] = static_cast<float>(sums_[i] / rays_);
        }
    }
    return image;
}

double TruthAverage::noise() const {
    double sum = 0.0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < sums_.size(); ++i) {
        if (sums_[i] >= 0.0) {
            sum += variances_[i];
            ++count;
        }
    }
    return count == 0 ? 0.0 : std::sqrt(sum / static_cast<double>(count)) / rays_;
}

int raysOfNextPass(int traced, int wanted) {
    const auto cells = [](int rays) { return static_cast<int>(std::sqrt(0.5 * rays)); };
    const int growing = cells(traced) + 1;
    const int fitting = std::max(1, cells(std::max(wanted - traced, 2)));
    const int chosen = std::min({growing, fitting, kMostCells});
    return 2 * chosen * chosen;
}

} // namespace aolib::viewer
