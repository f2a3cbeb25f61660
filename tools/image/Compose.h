#pragma once

#include <span>

#include "image/Image.h"
#include "image/ImageError.h"

namespace aolib {

/// Pixels of the line between two pictures of a strip; its grey is 64.
inline constexpr int separatorWidth = 2;

/// Puts pictures beside each other, left to right, bottoms aligned, as RGB. Lower ones are filled
/// up with the separator's grey. Takes 1 to 4 channels each, mixed as they come.
/// Errors: no picture; one without pixels, or with other channels or values than its size takes,
/// naming its place; a strip wider than 65536 pixels.
Result<ByteImage, ImageError> sideBySide(std::span<const ByteImage> pictures);

} // namespace aolib
