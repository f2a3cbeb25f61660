#include "viewer/ViewError.h"

#include <algorithm>
#include <cmath>

namespace aolib::viewer {

std::optional<ViewError> viewError(const FloatImage& visibility, const FloatImage& truth,
                                   double noise) {
    if (visibility.width != truth.width || visibility.height != truth.height) {
        return std::nullopt;
    }
    ViewError error;
    double squares = 0.0;
    for (std::size_t i = 0; i < truth.pixels.size(); ++i) {
        if (visibility.pixels[i] >= 0.0F && truth.pixels[i] >= 0.0F) {
            const double difference =
                static_cast<double>(visibility.pixels[i]) - static_cast<double>(truth.pixels[i]);
            error.bias += difference;
            squares += difference * difference;
            ++error.pixels;
        }
    }
    if (error.pixels == 0) {
        return std::nullopt;
    }
    const auto count = static_cast<double>(error.pixels);
    error.bias /= count;
    error.rmse = std::sqrt(std::max(squares / count - noise * noise, 0.0));
    return error;
}

} // namespace aolib::viewer
