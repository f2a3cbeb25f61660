#pragma once

#include <string>

#include <gtest/gtest.h>

#include "image/Image.h"

namespace aolib::test {

/// How far a picture may lie from its golden one, in levels of 0 to 255.
///
/// Drivers cover the pixels of edges differently. So a pixel's error is its distance from the range
/// of values that the golden picture has in the 3 x 3 pixels about it: an edge may move by one.
struct GoldenThresholds {
    double max = 0.0;  ///< of any channel of any pixel
    double mean = 0.0; ///< over all channels of all pixels
};

/// Compares a picture with tests/image/goldens/`name`.png; what differs goes to the build folder.
///
/// With the environment variable AOLIB_UPDATE_GOLDENS=1 it rewrites the golden picture instead, and
/// fails, so that a run that updates is never taken for one that tests.
testing::AssertionResult matchesGolden(const ByteImage& picture, const std::string& name,
                                       const GoldenThresholds& thresholds);

} // namespace aolib::test
