#include "image/ImagePair.h"

#include <cmath>
#include <string>

namespace aolib {

namespace {

std::string sizeOf(const FloatImage& image) {
    return std::to_string(image.width) + " x " + std::to_string(image.height) + " x " +
           std::to_string(image.channels);
}

bool consistent(const FloatImage& image) {
    return image.width > 0 && image.height > 0 && image.channels == 1 &&
           image.pixels.size() == image.pixelCount();
}

ImageOutcome checkFinite(const FloatImage& image, const std::string& name) {
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const float value = image.at(x, y);
            if (!std::isfinite(value)) {
                return ImageError{name + " is " + (std::isnan(value) ? "NaN" : "infinite") +
                                  " at pixel (" + std::to_string(x) + ", " + std::to_string(y) +
                                  ")"};
            }
        }
    }
    return std::nullopt;
}

} // namespace

ImageOutcome checkPair(const FloatImage& test, const FloatImage& reference) {
    if (test.width != reference.width || test.height != reference.height ||
        test.channels != reference.channels) {
        return ImageError{"sizes differ, the test is " + sizeOf(test) + ", the reference " +
                          sizeOf(reference)};
    }
    if (!consistent(test) || !consistent(reference)) {
        return ImageError{"pictures of one channel are compared, the test is " + sizeOf(test) +
                          " with " + std::to_string(test.pixels.size()) +
                          " values, the reference has " + std::to_string(reference.pixels.size())};
    }
    if (ImageOutcome error = checkFinite(test, "the test")) {
        return error;
    }
    return checkFinite(reference, "the reference");
}

} // namespace aolib
