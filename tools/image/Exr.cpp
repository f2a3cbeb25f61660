#include "image/Exr.h"

#include <bit>
#include <cstddef>
#include <string_view>
#include <utility>

namespace aolib {

namespace {

// As the OpenEXR file layout calls them.
constexpr std::uint32_t magic = 20000630;
constexpr std::uint32_t version = 2;
constexpr std::uint32_t pixelTypeFloat = 2;
constexpr std::uint8_t noCompression = 0;
constexpr std::uint8_t increasingY = 0;

/// Bytes in the order of the file, lowest first.
class ExrBytes {
public:
    void text(std::string_view value) {
        for (const char c : value) {
            byte(static_cast<std::uint8_t>(c));
        }
        byte(0);
    }
    void byte(std::uint8_t value) { content_.push_back(value); }
    void u32(std::uint32_t value) {
        for (unsigned shift = 0; shift < 32; shift += 8) {
            byte(static_cast<std::uint8_t>(value >> shift));
        }
    }
    void u64(std::uint64_t value) {
        u32(static_cast<std::uint32_t>(value));
        u32(static_cast<std::uint32_t>(value >> 32U));
    }
    void real(float value) { u32(std::bit_cast<std::uint32_t>(value)); }
    /// The beginning of an attribute: its value, of `size` bytes, follows.
    void attribute(std::string_view name, std::string_view type, std::uint32_t size) {
        text(name);
        text(type);
        u32(size);
    }
    void reserve(std::size_t size) { content_.reserve(size); }
    std::size_t size() const { return content_.size(); }
    std::vector<std::uint8_t> take() { return std::move(content_); }

private:
    std::vector<std::uint8_t> content_;
};

void addWindow(ExrBytes& bytes, std::string_view name, const FloatImage& image) {
    bytes.attribute(name, "box2i", 16);
    bytes.u32(0);
    bytes.u32(0);
    bytes.u32(static_cast<std::uint32_t>(image.width - 1));
    bytes.u32(static_cast<std::uint32_t>(image.height - 1));
}

/// @param names  one letter each, in the alphabet's order.
void addHeader(ExrBytes& bytes, const FloatImage& image, std::string_view names) {
    bytes.u32(magic);
    bytes.u32(version);
    bytes.attribute("channels", "chlist", static_cast<std::uint32_t>(names.size()) * 18 + 1);
    for (std::size_t i = 0; i < names.size(); ++i) {
        bytes.text(names.substr(i, 1));
        bytes.u32(pixelTypeFloat);
        bytes.u32(0); // not perceptual; three reserved bytes
        bytes.u32(1); // every column
        bytes.u32(1); // every row
    }
    bytes.byte(0);
    bytes.attribute("compression", "compression", 1);
    bytes.byte(noCompression);
    addWindow(bytes, "dataWindow", image);
    addWindow(bytes, "displayWindow", image);
    bytes.attribute("lineOrder", "lineOrder", 1);
    bytes.byte(increasingY);
    bytes.attribute("pixelAspectRatio", "float", 4);
    bytes.real(1.0F);
    bytes.attribute("screenWindowCenter", "v2f", 8);
    bytes.real(0.0F);
    bytes.real(0.0F);
    bytes.attribute("screenWindowWidth", "float", 4);
    bytes.real(1.0F);
    bytes.byte(0);
}

} // namespace

std::vector<std::uint8_t> encodedExr(const FloatImage& image) {
    if (image.width < 1 || image.height < 1 || (image.channels != 1 && image.channels != 3)) {
        return {};
    }
    ExrBytes bytes;
    addHeader(bytes, image, image.channels == 1 ? "Y" : "BGR");
    const auto rows = static_cast<std::size_t>(image.height);
    const std::size_t row =
        4 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.channels);
    const std::size_t start = bytes.size() + 8 * rows;
    bytes.reserve(start + (8 + row) * rows);
    for (std::size_t y = 0; y < rows; ++y) {
        bytes.u64(start + (8 + row) * y);
    }
    for (int y = 0; y < image.height; ++y) {
        bytes.u32(static_cast<std::uint32_t>(y));
        bytes.u32(static_cast<std::uint32_t>(row));
        for (int channel = image.channels - 1; channel >= 0; --channel) {
            for (int x = 0; x < image.width; ++x) {
                bytes.real(image.at(x, image.height - 1 - y, channel)); // its rows begin at the top
            }
        }
    }
    return bytes.take();
}

} // namespace aolib
