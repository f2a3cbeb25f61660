#pragma once

#include <cstdint>
#include <vector>

#include "image/Image.h"

namespace aolib {

/// An OpenEXR file of a picture of 1 channel (named Y) or 3 (R, G, B): single precision, one
/// scanline after the other, not compressed. Empty where the channels are others or there are no
/// pixels.
std::vector<std::uint8_t> encodedExr(const FloatImage& image);

} // namespace aolib
