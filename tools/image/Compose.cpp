#include "image/Compose.h"

#include <algorithm>
#include <cstdint>
#include <string>

#include "image/FalseColour.h"

namespace aolib {

namespace {

constexpr std::uint8_t separatorGrey = 64;
constexpr std::int64_t widestStrip = 65536;

bool usable(const ByteImage& picture) {
    return picture.width > 0 && picture.height > 0 && picture.channels >= 1 &&
           picture.channels <= 4 &&
           picture.pixels.size() ==
               picture.pixelCount() * static_cast<std::size_t>(picture.channels);
}

/// Copies `picture` (RGB) into `strip` (RGB) from column `left`, row 0.
void place(const ByteImage& picture, ByteImage& strip, int left) {
    const std::size_t rowLength = std::size_t{3} * static_cast<std::size_t>(picture.width);
    for (int y = 0; y < picture.height; ++y) {
        std::copy_n(&picture.at(0, y), rowLength, &strip.at(left, y));
    }
}

} // namespace

Result<ByteImage, ImageError> sideBySide(std::span<const ByteImage> pictures) {
    if (pictures.empty()) {
        return ImageError{"there is no picture to put side by side"};
    }
    std::int64_t width = -separatorWidth;
    int height = 0;
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        if (!usable(pictures[i])) {
            return ImageError{"picture " + std::to_string(i) + " of a strip is " +
                              std::to_string(pictures[i].width) + " x " +
                              std::to_string(pictures[i].height) + " x " +
                              std::to_string(pictures[i].channels) + " and holds " +
                              std::to_string(pictures[i].pixels.size()) + " values"};
        }
        width += std::int64_t{pictures[i].width} + separatorWidth;
        height = std::max(height, pictures[i].height);
    }
    if (width > widestStrip) {
        return ImageError{"a strip of " + std::to_string(width) +
                          " pixels, must be at most 65536 wide"};
    }
    ByteImage strip(static_cast<int>(width), height, 3, separatorGrey);
    int left = 0;
    for (const ByteImage& picture : pictures) {
        place(rgbPicture(picture), strip, left);
        left += picture.width + separatorWidth;
    }
    return strip;
}

} // namespace aolib
