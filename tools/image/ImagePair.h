#pragma once

#include "image/Image.h"
#include "image/ImageError.h"

namespace aolib {

/// Whether two pictures of W can be compared: one channel each, equal sizes, as many values as the
/// size takes, all finite. Otherwise the reason, with both sizes or with picture and pixel (x from
/// the left, y from the bottom).
ImageOutcome checkPair(const FloatImage& test, const FloatImage& reference);

} // namespace aolib
