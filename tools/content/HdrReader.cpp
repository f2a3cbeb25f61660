#include "content/HdrReader.h"

#include <climits>
#include <cstddef>
#include <string>

// The implementation is private to this file: other libraries may bring one of their own.
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_HDR
#define STBI_NO_STDIO
#define STBI_MAX_DIMENSIONS 16384
#include <stb/stb_image.h>

namespace aolib {

Result<lighting::EnvironmentMap, LoadError> readHdr(std::string_view bytes,
                                                    const std::filesystem::path& file) {
    const auto* content = reinterpret_cast<const stbi_uc*>(bytes.data());
    const int size = bytes.size() > std::size_t{INT_MAX} ? 0 : static_cast<int>(bytes.size());
    if (stbi_is_hdr_from_memory(content, size) == 0) {
        return LoadError{file.string() + ": not a Radiance .hdr file"};
    }
    constexpr int channels = 3;
    lighting::EnvironmentMap map;
    int given = 0;
    float* pixels =
        stbi_loadf_from_memory(content, size, &map.width, &map.height, &given, channels);
    if (pixels == nullptr) {
        const char* reason = stbi_failure_reason();
        return LoadError{file.string() +
                         ": cannot be read: " + (reason == nullptr ? "unknown reason" : reason)};
    }
    const auto width = static_cast<std::size_t>(map.width);
    const auto height = static_cast<std::size_t>(map.height);
    map.radiance.resize(width * height);
    for (std::size_t y = 0; y < height; ++y) {
        const float* row = pixels + (height - 1 - y) * width * channels; // stb begins at the top
        for (std::size_t x = 0; x < width; ++x) {
            map.radiance[y * width + x] = {row[channels * x], row[channels * x + 1],
                                           row[channels * x + 2]};
        }
    }
    stbi_image_free(pixels);
    if (const AoStatus status = lighting::checkEnvironment(map); !status) {
        return LoadError{file.string() + ": " + status.message()};
    }
    return map;
}

} // namespace aolib
