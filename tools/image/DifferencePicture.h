#pragma once

#include "image/Image.h"
#include "image/ImageError.h"

namespace aolib {

/// Where and how a picture of W differs from another, in RGB: white where equal, towards red where
/// the test is too bright, towards blue where it is too dark, mid grey where either is background.
/// @param scale  the difference of W that is shown in full colour, above 0.
/// Errors: those of `compareImages()` but the lack of pixels; a scale that is not above 0.
Result<ByteImage, ImageError> differencePicture(const FloatImage& test, const FloatImage& reference,
                                                float scale);

} // namespace aolib
