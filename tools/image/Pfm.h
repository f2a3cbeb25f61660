#pragma once

#include <filesystem>

#include "image/Image.h"
#include "image/ImageError.h"

namespace aolib {

/// Writes a portable float map: "Pf" for 1 channel, "PF" for 3; rows from bottom to top, which is
/// how an `Image` holds them; little endian. The file appears whole or not at all.
/// Errors: other channel counts, an empty picture, values that do not fit its size, and whatever
/// the file system says.
ImageOutcome writePfm(const std::filesystem::path& file, const FloatImage& image);

/// Reads a portable float map of either byte order. The size of the scale is a physical unit and
/// left alone. NaN and infinity are read as they are.
/// Errors: not a PFM, a malformed header, a side outside 1 to 65536, fewer or more bytes than the
/// header promises; each names the file.
Result<FloatImage, ImageError> readPfm(const std::filesystem::path& file);

} // namespace aolib
