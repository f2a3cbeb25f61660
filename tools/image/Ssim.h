#pragma once

#include <optional>

#include "image/Image.h"

namespace aolib {

/// Mean structural similarity (Wang, Bovik, Sheikh, Simoncelli 2004) of two pictures of one channel
/// and equal size: Gaussian windows of 11 x 11 pixels, standard deviation 1.5, K1 = 0.01,
/// K2 = 0.03, range 1. Only windows that lie within the picture and are background in neither
/// picture count. Nothing when there is no such window. All values must be finite.
std::optional<double> meanSsim(const FloatImage& a, const FloatImage& b);

} // namespace aolib
