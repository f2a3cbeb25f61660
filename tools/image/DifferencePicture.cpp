#include "image/DifferencePicture.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include <glm/vec3.hpp>

#include "image/ImagePair.h"

namespace aolib {

namespace {

using Colour = glm::vec<3, std::uint8_t>;

constexpr Colour backgroundColour{128, 128, 128};

/// @param signedShare  of the full colour, -1 blue to 1 red.
Colour colourOf(double signedShare) {
    const double share = std::min(1.0, std::abs(signedShare));
    const auto rest = static_cast<std::uint8_t>(std::lround(255.0 * (1.0 - share)));
    return signedShare > 0.0 ? Colour{255, rest, rest} : Colour{rest, rest, 255};
}

} // namespace

Result<ByteImage, ImageError> differencePicture(const FloatImage& test, const FloatImage& reference,
                                                float scale) {
    if (const ImageOutcome error = checkPair(test, reference)) {
        return *error;
    }
    if (!(scale > 0.0F && std::isfinite(scale))) {
        return ImageError{"the scale of a difference picture is " + std::to_string(scale) +
                          ", must be above 0"};
    }
    ByteImage picture(test.width, test.height, 3);
    for (std::size_t i = 0; i < test.pixels.size(); ++i) {
        const bool empty =
            test.pixels[i] == backgroundValue || reference.pixels[i] == backgroundValue;
        const double difference = double{test.pixels[i]} - double{reference.pixels[i]};
        const Colour colour = empty ? backgroundColour : colourOf(difference / double{scale});
        for (int channel = 0; channel < 3; ++channel) {
            picture.pixels[3 * i + static_cast<std::size_t>(channel)] = colour[channel];
        }
    }
    return picture;
}

} // namespace aolib
