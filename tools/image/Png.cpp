#include "image/Png.h"

#include <algorithm>
#include <string>
#include <vector>

#include "image/FileContent.h"
#include "image/StbImage.h"

namespace aolib {

namespace {

constexpr int largestPng = 65536;
/// stb counts bytes in int.
constexpr std::size_t mostValues = std::size_t{1} << 30U;

/// The same rows in opposite order; its own inverse.
std::vector<std::uint8_t> turnedOver(const std::vector<std::uint8_t>& rows, std::size_t rowLength) {
    std::vector<std::uint8_t> result(rows.size());
    for (std::size_t begin = 0; begin < rows.size(); begin += rowLength) {
        std::copy_n(rows.data() + begin, rowLength,
                    result.data() + (rows.size() - begin - rowLength));
    }
    return result;
}

std::size_t rowLength(int width, int channels) {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(channels);
}

} // namespace

ImageOutcome writePng(const std::filesystem::path& file, const ByteImage& image) {
    if (image.channels != 1 && image.channels != 3 && image.channels != 4) {
        return ImageError{file.string() + ": PNG is written with 1, 3 or 4 channels, not " +
                          std::to_string(image.channels)};
    }
    if (image.width < 1 || image.width > largestPng || image.height < 1 ||
        image.height > largestPng || image.pixels.size() > mostValues ||
        image.pixels.size() != image.pixelCount() * static_cast<std::size_t>(image.channels)) {
        return ImageError{file.string() + ": the picture to write is " +
                          std::to_string(image.width) + " x " + std::to_string(image.height) +
                          " pixels and holds " + std::to_string(image.pixels.size()) + " values"};
    }
    const std::vector<std::uint8_t> content =
        stb::encodePng({image.width, image.height, image.channels,
                        turnedOver(image.pixels, rowLength(image.width, image.channels))});
    if (content.empty()) {
        return ImageError{file.string() + ": cannot be encoded, out of memory"};
    }
    return writeFile(file, content);
}

Result<ByteImage, ImageError> readPng(const std::filesystem::path& file) {
    const Result<std::vector<std::uint8_t>, ImageError> content = readFile(file);
    if (!content) {
        return ImageError{content.error().message};
    }
    const Result<stb::TopDownPixels, ImageError> decoded = stb::decodePng(*content);
    if (!decoded) {
        return ImageError{file.string() +
                          ": not a PNG that can be read: " + decoded.error().message};
    }
    ByteImage image;
    image.width = decoded->width;
    image.height = decoded->height;
    image.channels = decoded->channels;
    image.pixels = turnedOver(decoded->bytes, rowLength(image.width, image.channels));
    return image;
}

} // namespace aolib
