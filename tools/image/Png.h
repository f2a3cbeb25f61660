#pragma once

#include <filesystem>

#include "image/Image.h"
#include "image/ImageError.h"

namespace aolib {

/// Writes an 8 bit PNG of 1 (grey), 3 (RGB) or 4 (RGBA) channels. PNG goes from top to bottom, so
/// rows are turned over. The file appears whole or not at all.
/// Errors: other channel counts, a side outside 1 to 65536, more than 2^30 values, values that do
/// not fit the size, and whatever the file system says.
ImageOutcome writePng(const std::filesystem::path& file, const ByteImage& image);

/// Reads a PNG with the channels that it has, 1 to 4; 16 bit values lose their lower byte.
/// Errors: not a PNG, damaged or truncated, a side above 65536; each names the file.
Result<ByteImage, ImageError> readPng(const std::filesystem::path& file);

} // namespace aolib
