#include "image/Png16.h"

#include <array>
#include <cstddef>
#include <string_view>

#include "image/StbImage.h"

namespace aolib {

namespace {

using Bytes = std::vector<std::uint8_t>;

/// The checksum of PNG's chunks (ISO 3309), bit by bit.
std::uint32_t checksum(const Bytes& bytes) {
    std::uint32_t sum = ~0U;
    for (const std::uint8_t byte : bytes) {
        sum ^= byte;
        for (int bit = 0; bit < 8; ++bit) {
            sum = (sum >> 1U) ^ ((sum & 1U) != 0 ? 0xedb88320U : 0U);
        }
    }
    return ~sum;
}

void append(Bytes& out, std::uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8) {
        out.push_back(static_cast<std::uint8_t>(value >> static_cast<unsigned>(shift)));
    }
}

void appendChunk(Bytes& out, std::string_view kind, const Bytes& content) {
    append(out, static_cast<std::uint32_t>(content.size()));
    Bytes checked(kind.begin(), kind.end());
    checked.insert(checked.end(), content.begin(), content.end());
    out.insert(out.end(), checked.begin(), checked.end());
    append(out, checksum(checked));
}

template <typename T>
Bytes encoded(const Image<T>& image) {
    const auto width = static_cast<std::size_t>(image.width);
    const auto channels = static_cast<std::size_t>(image.channels);
    if ((channels != 1 && channels != 3) || image.width < 1 || image.height < 1 ||
        image.pixels.size() != image.pixelCount() * channels) {
        return {};
    }
    Bytes rows; // from top to bottom, each after its filter: the difference to the pixel before
    rows.reserve(image.pixels.size() * sizeof(T) + static_cast<std::size_t>(image.height));
    const std::size_t pixel = channels * sizeof(T);
    Bytes row(width * pixel);
    for (int y = image.height - 1; y >= 0; --y) {
        for (std::size_t i = 0; i < width * channels; ++i) {
            const T value = image.pixels[image.index(0, y) + i];
            for (std::size_t byte = 0; byte < sizeof(T); ++byte) {
                row[i * sizeof(T) + byte] = static_cast<std::uint8_t>(
                    static_cast<unsigned>(value) >> (8 * (sizeof(T) - 1 - byte)));
            }
        }
        constexpr std::uint8_t filterSub = 1;
        rows.push_back(filterSub);
        for (std::size_t i = 0; i < row.size(); ++i) {
            const int before = i < pixel ? 0 : row[i - pixel];
            rows.push_back(static_cast<std::uint8_t>(row[i] - before));
        }
    }
    const Bytes packed = stb::deflate(rows);
    if (packed.empty()) {
        return {};
    }
    constexpr std::uint8_t grey = 0;
    constexpr std::uint8_t rgb = 2;
    Bytes header;
    append(header, static_cast<std::uint32_t>(image.width));
    append(header, static_cast<std::uint32_t>(image.height));
    header.push_back(8 * sizeof(T));
    header.push_back(channels == 1 ? grey : rgb);
    header.insert(header.end(), {0, 0, 0}); // deflate, the five filters, not interlaced
    Bytes out{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    appendChunk(out, "IHDR", header);
    appendChunk(out, "IDAT", packed);
    appendChunk(out, "IEND", {});
    return out;
}

} // namespace

std::vector<std::uint8_t> encodedPng(const ByteImage& image) {
    return encoded(image);
}

std::vector<std::uint8_t> encodedPng(const WordImage& image) {
    return encoded(image);
}

} // namespace aolib
