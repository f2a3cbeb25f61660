#pragma once

#include <cstddef>
#include <optional>

#include "image/Image.h"

namespace aolib::viewer {

/// How far a picture of W lies from the truth, over the pixels that both know.
struct ViewError {
    double rmse = 0.0; ///< the truth's noise taken off
    double bias = 0.0; ///< mean of picture minus truth
    std::size_t pixels = 0;
};

/// Nothing where sizes differ or no pixel is known to both.
/// @param noise  the RMSE of the truth by itself.
std::optional<ViewError> viewError(const FloatImage& visibility, const FloatImage& truth,
                                   double noise);

} // namespace aolib::viewer
