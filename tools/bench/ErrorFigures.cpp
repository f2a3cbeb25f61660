#include "bench/ErrorFigures.h"

#include <algorithm>
#include <cmath>

namespace aolib::bench {

namespace {

/// Counted for a W that is NaN or infinite.
constexpr double kWorstError = 1.0;

/// Of |error|: the smallest that 95% of the points do not exceed.
double percentile95(std::vector<double>& errors) {
    const auto rank = static_cast<std::size_t>(std::ceil(0.95 * double(errors.size())));
    const auto at =
        errors.begin() + static_cast<std::ptrdiff_t>(std::max<std::size_t>(rank, 1) - 1);
    std::nth_element(errors.begin(), at, errors.end());
    return *at;
}

} // namespace

ErrorFigures comparePoints(std::span<const float> values, const Truth& truth) {
    ErrorFigures figures;
    std::vector<double> errors;
    double sum = 0.0;
    double squares = 0.0;
    double noise = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (values[i] < 0.0F && std::isfinite(values[i])) {
            continue; // no surface
        }
        const bool number = std::isfinite(values[i]);
        const double error = number ? double{values[i]} - double{truth.visibility[i]} : kWorstError;
        figures.notNumbers += number ? 0U : 1U;
        const double standardError = double{truth.standardError[i]};
        sum += error;
        squares += error * error;
        noise += standardError * standardError;
        errors.push_back(std::abs(error));
    }
    const auto count = static_cast<double>(errors.size());
    figures.missing = values.empty() ? 0.0 : 1.0 - count / static_cast<double>(values.size());
    if (errors.empty()) {
        return figures;
    }
    figures.rmse = std::sqrt(std::max(squares - noise, 0.0) / count);
    figures.bias = sum / count;
    figures.maximum = *std::max_element(errors.begin(), errors.end());
    figures.percentile95 = percentile95(errors);
    return figures;
}

ErrorFigures compareWithTruth(std::span<const float> picture, const Truth& truth) {
    std::vector<float> values;
    values.reserve(truth.receivers.pixels.size());
    for (const std::uint32_t pixel : truth.receivers.pixels) {
        values.push_back(picture[pixel]);
    }
    return comparePoints(values, truth);
}

} // namespace aolib::bench
