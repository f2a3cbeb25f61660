#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

/// What the examples without a window share: a size, a camera, arguments, a file.
namespace stage {

inline constexpr int kWidth = 480;  ///< pixels
inline constexpr int kHeight = 270; ///< pixels

/// Looks at the boxes of groundWithBoxes().
struct Camera {
    glm::vec3 eye;
    glm::mat4 view;
    glm::mat4 projection;
};
Camera camera();

/// "[--without | --neutral] PICTURE.ppm", the arguments of every example.
struct Arguments {
    bool ambientOcclusion = true; ///< not with --without
    bool neutral = false;         ///< it may change nothing
    std::string picture;          ///< empty: the arguments were wrong, and the usage was printed
};
Arguments parse(int argc, char** argv);

/// Writes RGB bytes, the bottom row first, as a PPM file. @return the program's exit status.
int save(const std::string& path, const std::vector<std::uint8_t>& rgb);

/// Prints why there is no picture. @return the program's exit status.
int fail(const std::string& reason);

} // namespace stage
