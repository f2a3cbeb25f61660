#include "image/ToneMap.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace aolib {

ByteImage toneMapped(const FloatImage& radiance, float exposure) {
    constexpr float displayGamma = 2.2F;
    ByteImage picture(radiance.width, radiance.height, radiance.channels);
    std::transform(radiance.pixels.begin(), radiance.pixels.end(), picture.pixels.begin(),
                   [&](float value) {
                       const float shown = 1.0F - std::exp(-exposure * std::max(value, 0.0F));
                       return static_cast<std::uint8_t>(
                           std::lround(255.0F * std::pow(shown, 1.0F / displayGamma)));
                   });
    return picture;
}

} // namespace aolib
