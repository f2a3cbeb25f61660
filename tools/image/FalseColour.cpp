#include "image/FalseColour.h"

#include <algorithm>
#include <cmath>

namespace aolib {

ByteImage greyPicture(const FloatImage& visibility, std::uint8_t background) {
    ByteImage picture(visibility.width, visibility.height, 1);
    std::ranges::transform(visibility.pixels, picture.pixels.begin(), [&](float w) {
        if (w == backgroundValue || std::isnan(w)) {
            return background;
        }
        return static_cast<std::uint8_t>(std::lround(255.0F * std::clamp(w, 0.0F, 1.0F)));
    });
    return picture;
}

ByteImage rgbPicture(const ByteImage& picture) {
    ByteImage rgb(picture.width, picture.height, 3);
    const auto channels = static_cast<std::size_t>(picture.channels);
    for (std::size_t i = 0; i < picture.pixelCount(); ++i) {
        for (std::size_t channel = 0; channel < 3; ++channel) {
            rgb.pixels[3 * i + channel] =
                picture.pixels[channels * i + (channels >= 3 ? channel : 0)];
        }
    }
    return rgb;
}

} // namespace aolib
