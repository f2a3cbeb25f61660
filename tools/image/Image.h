#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace aolib {

/// A picture in memory: rows from bottom to top as OpenGL has them, channels interleaved.
template <typename T>
struct Image {
    int width = 0;         ///< pixels
    int height = 0;        ///< pixels
    int channels = 0;      ///< values per pixel
    std::vector<T> pixels; ///< `width * height * channels` values, the bottom row first

    Image() = default;
    Image(int w, int h, int c, T value = T{})
        : width(w), height(h), channels(c),
          pixels(static_cast<std::size_t>(w) * static_cast<std::size_t>(h) *
                     static_cast<std::size_t>(c),
                 value) {}

    std::size_t pixelCount() const {
        return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    }
    /// Where the value of `channel` at column `x` of row `y` lies in `pixels`.
    std::size_t index(int x, int y, int channel = 0) const {
        return (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                static_cast<std::size_t>(x)) *
                   static_cast<std::size_t>(channels) +
               static_cast<std::size_t>(channel);
    }
    T& at(int x, int y, int channel = 0) { return pixels[index(x, y, channel)]; }
    const T& at(int x, int y, int channel = 0) const { return pixels[index(x, y, channel)]; }

    bool operator==(const Image&) const = default;
};

/// Measured values, such as visibility W.
using FloatImage = Image<float>;
/// 8 bit per channel: grey, grey and alpha, RGB or RGBA.
using ByteImage = Image<std::uint8_t>;

/// The value of W where a pixel shows no surface.
inline constexpr float backgroundValue = -1.0F;

} // namespace aolib
