#pragma once

#include <cstdint>
#include <vector>

#include "image/Image.h"

namespace aolib {

/// 16 bit per channel.
using WordImage = Image<std::uint16_t>;

/// The content of a PNG file of 8 or 16 bit per channel, 1 (grey) or 3 (RGB) channels; empty for
/// others, for pictures that do not fit their size, and when memory runs out.
std::vector<std::uint8_t> encodedPng(const ByteImage& image);
std::vector<std::uint8_t> encodedPng(const WordImage& image);

} // namespace aolib
