#include "image/StbImage.h"

#include <climits>

// The implementation is private to this file: other libraries may bring one of their own.
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#define STBI_NO_STDIO
#define STBI_MAX_DIMENSIONS 65536
#include <stb/stb_image.h>

#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STBI_WRITE_NO_STDIO
#include <stb/stb_image_write.h>

namespace aolib::stb {

Result<TopDownPixels, ImageError> decodePng(std::span<const std::uint8_t> content) {
    if (content.size() > static_cast<std::size_t>(INT_MAX)) {
        return ImageError{"too large"};
    }
    TopDownPixels pixels;
    stbi_uc* decoded = stbi_load_from_memory(content.data(), static_cast<int>(content.size()),
                                             &pixels.width, &pixels.height, &pixels.channels, 0);
    if (decoded == nullptr) {
        const char* reason = stbi_failure_reason();
        return ImageError{reason == nullptr ? "unknown reason" : reason};
    }
    const std::size_t size = static_cast<std::size_t>(pixels.width) *
                             static_cast<std::size_t>(pixels.height) *
                             static_cast<std::size_t>(pixels.channels);
    pixels.bytes.assign(decoded, decoded + size);
    stbi_image_free(decoded);
    return pixels;
}

std::vector<std::uint8_t> encodePng(const TopDownPixels& pixels) {
    std::vector<std::uint8_t> content;
    const auto append = [](void* context, void* data, int size) {
        const auto* bytes = static_cast<const std::uint8_t*>(data);
        static_cast<std::vector<std::uint8_t>*>(context)->assign(bytes, bytes + size);
    };
    const int done = stbi_write_png_to_func(append, &content, pixels.width, pixels.height,
                                            pixels.channels, pixels.bytes.data(), 0);
    if (done == 0) {
        content.clear();
    }
    return content;
}

std::vector<std::uint8_t> deflate(const std::vector<std::uint8_t>& bytes) {
    constexpr int quality = 8;
    int length = 0;
    // stb asks for bytes that it may change and does not.
    unsigned char* packed = stbi_zlib_compress(const_cast<unsigned char*>(bytes.data()), // NOLINT
                                               static_cast<int>(bytes.size()), &length, quality);
    if (packed == nullptr) {
        return {};
    }
    std::vector<std::uint8_t> result(packed, packed + length);
    STBIW_FREE(packed);
    return result;
}

} // namespace aolib::stb
