#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <aolib/bake/AbstractBaker.h>

#include "app/OutputFiles.h"
#include "image/Image.h"

namespace aolib::app {

/// A baked map as a picture; where it has no value there is 0.
struct BakedImage {
    FloatImage values;
    bool directions = false; ///< components from -1 to 1, which PNGs hold as n * 0.5 + 0.5
};

BakedImage occlusionImage(const bake::BakedMap& map);
BakedImage directionImage(const bake::BakedMap& map);

/// With the dot, of files that putImage() can write.
const std::vector<std::string>& bakedImageExtensions();

/// @param bits  per channel, 8 or 16.
std::vector<std::uint8_t> encodedPng(const BakedImage& image, int bits);

/// Gives an announced file an image, in the format that its extension names.
/// @param bits  per channel of a PNG.
void putImage(OutputFiles& files, const std::filesystem::path& file, BakedImage image, int bits);

} // namespace aolib::app
