#include "app/BakedImage.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>

#include "image/Exr.h"
#include "image/Png16.h"

namespace aolib::app {

BakedImage occlusionImage(const bake::BakedMap& map) {
    BakedImage image{FloatImage(map.width, map.height, 1), false};
    std::transform(map.visibility.begin(), map.visibility.end(), image.values.pixels.begin(),
                   [](float w) { return std::max(w, 0.0F); });
    return image;
}

BakedImage directionImage(const bake::BakedMap& map) {
    BakedImage image{FloatImage(map.width, map.height, 3), true};
    std::size_t next = 0;
    for (const glm::vec3& direction : map.bentNormal) {
        for (const float component : {direction.x, direction.y, direction.z}) {
            image.values.pixels[next++] = component;
        }
    }
    return image;
}

const std::vector<std::string>& bakedImageExtensions() {
    static const std::vector<std::string> extensions{".png", ".pfm", ".exr"};
    return extensions;
}

std::vector<std::uint8_t> encodedPng(const BakedImage& image, int bits) {
    const FloatImage& from = image.values;
    const auto converted = [&](auto png, float most) {
        using Pixel = std::remove_reference_t<decltype(png.pixels[0])>;
        std::transform(from.pixels.begin(), from.pixels.end(), png.pixels.begin(), [&](float v) {
            const float share = image.directions ? 0.5F * v + 0.5F : v;
            return static_cast<Pixel>(std::lround(std::clamp(share, 0.0F, 1.0F) * most));
        });
        return aolib::encodedPng(png);
    };
    return bits == 16 ? converted(WordImage(from.width, from.height, from.channels), 65535.0F)
                      : converted(ByteImage(from.width, from.height, from.channels), 255.0F);
}

void putImage(OutputFiles& files, const std::filesystem::path& file, BakedImage image, int bits) {
    if (file.extension() == ".pfm") {
        files.put(file, std::move(image.values));
    } else if (file.extension() == ".exr") {
        files.put(file, encodedExr(image.values));
    } else {
        files.put(file, encodedPng(image, bits));
    }
}

} // namespace aolib::app
