#include "image/Metrics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "image/ImagePair.h"
#include "image/Ssim.h"

namespace aolib {

namespace {

/// The errors of the pixels that are background in neither; counts the others.
std::vector<double> errorsOf(const FloatImage& test, const FloatImage& reference,
                             Metrics& metrics) {
    std::vector<double> errors;
    errors.reserve(test.pixels.size());
    for (std::size_t i = 0; i < test.pixels.size(); ++i) {
        const bool testEmpty = test.pixels[i] == backgroundValue;
        const bool referenceEmpty = reference.pixels[i] == backgroundValue;
        if (!testEmpty && !referenceEmpty) {
            errors.push_back(double{test.pixels[i]} - double{reference.pixels[i]});
        } else if (!referenceEmpty) {
            ++metrics.backgroundOnlyInTest;
        } else if (!testEmpty) {
            ++metrics.backgroundOnlyInReference;
        }
    }
    return errors;
}

/// Nearest rank: the smallest value that at least 95 in 100 do not exceed. Reorders the values.
double percentile95(std::vector<double>& values) {
    const std::size_t rank = (values.size() * 95 + 99) / 100;
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(rank - 1);
    std::ranges::nth_element(values, at);
    return *at;
}

} // namespace

Result<Metrics, ImageError> compareImages(const FloatImage& test, const FloatImage& reference) {
    if (const ImageOutcome error = checkPair(test, reference)) {
        return *error;
    }
    Metrics metrics;
    std::vector<double> errors = errorsOf(test, reference, metrics);
    metrics.pixels = errors.size();
    if (errors.empty()) {
        return ImageError{"there is no pixel to compare, each is background in one picture"};
    }
    const auto count = static_cast<double>(errors.size());
    double squares = 0.0;
    for (double& error : errors) {
        metrics.bias += error / count;
        squares += error * error;
        error = std::abs(error);
        metrics.mae += error / count;
        metrics.maximum = std::max(metrics.maximum, error);
    }
    metrics.rmse = std::sqrt(squares / count);
    metrics.psnr = metrics.rmse > 0.0 ? -20.0 * std::log10(metrics.rmse)
                                      : std::numeric_limits<double>::infinity();
    metrics.percentile95 = percentile95(errors);
    metrics.ssim = meanSsim(test, reference);
    return metrics;
}

} // namespace aolib
