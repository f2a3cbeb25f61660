#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "image/ImageError.h"

namespace aolib::stb {

/// Pixels as stb has them: rows from top to bottom.
struct TopDownPixels {
    int width = 0;
    int height = 0;
    int channels = 0; ///< 1 grey, 2 grey and alpha, 3 RGB, 4 RGBA
    std::vector<std::uint8_t> bytes;
};

/// The pixels of a PNG file's content, or stb's reason. 16 bit files lose their lower bytes.
Result<TopDownPixels, ImageError> decodePng(std::span<const std::uint8_t> content);

/// The bytes as zlib packs them, empty when memory runs out.
std::vector<std::uint8_t> deflate(const std::vector<std::uint8_t>& bytes);

/// A PNG file's content, empty when memory runs out.
std::vector<std::uint8_t> encodePng(const TopDownPixels& pixels);

} // namespace aolib::stb
