#pragma once

#include "app/Failure.h"
#include "app/TruthJob.h"
#include "image/Image.h"
#include "image/Metrics.h"

namespace aolib::app {

/// The difference of W that difference pictures show in full colour, unless told otherwise.
inline constexpr float kDifferenceScale = 0.25F;

/// How a rendered picture of W compares with the ray-traced one.
struct ErrorAgainstTruth {
    Metrics metrics;
    double truthNoise = 0.0; ///< expected RMSE of the truth itself
    int rays = 0;            ///< per pixel, of the truth
};

/// Errors: Failed, when they cannot be compared: NaN, or no pixel with a surface in both.
Result<ErrorAgainstTruth, Failure> compareWithTruth(const FloatImage& visibility,
                                                    const Truth& truth);

/// Where and how W differs from the truth. Errors: as compareWithTruth().
Result<ByteImage, Failure> differenceFromTruth(const FloatImage& visibility, const Truth& truth);

} // namespace aolib::app
