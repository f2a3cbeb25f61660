#pragma once

#include <cstdint>

#include "image/Image.h"

namespace aolib {

/// W of one channel as a grey picture of one channel: 0 black, 1 white, values beyond clamped.
/// @param background  the grey of background pixels (-1) and of NaN.
ByteImage greyPicture(const FloatImage& visibility, std::uint8_t background = 255);

/// The same picture with three channels: grey becomes RGB; alpha is dropped.
/// Takes 1 to 4 channels.
ByteImage rgbPicture(const ByteImage& picture);

} // namespace aolib
