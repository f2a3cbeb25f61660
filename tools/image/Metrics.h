#pragma once

#include <cstddef>
#include <optional>

#include "image/Image.h"
#include "image/ImageError.h"

namespace aolib {

/// How far a picture of W lies from another, over the pixels that are background in neither.
/// Errors are `test - reference`.
struct Metrics {
    std::size_t pixels = 0;                    ///< compared
    std::size_t backgroundOnlyInTest = 0;      ///< not compared: surface missing from the test
    std::size_t backgroundOnlyInReference = 0; ///< not compared: surface added by the test
    double rmse = 0.0;
    double mae = 0.0;
    double bias = 0.0;          ///< mean error, below 0 where the test is too dark
    double percentile95 = 0.0;  ///< of |error|: the smallest that 95% of the pixels do not exceed
    double maximum = 0.0;       ///< of |error|
    double psnr = 0.0;          ///< dB for a peak of 1; infinite when equal
    std::optional<double> ssim; ///< see `meanSsim()`; nothing when no window fits
};

/// Compares two pictures of one channel, background -1.
/// Errors: sizes or channels that differ or fit no values; NaN or infinity, naming picture and
/// pixel (x from the left, y from the bottom); no pixel to compare.
Result<Metrics, ImageError> compareImages(const FloatImage& test, const FloatImage& reference);

} // namespace aolib
