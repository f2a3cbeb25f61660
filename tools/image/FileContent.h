#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "image/ImageError.h"

namespace aolib {

/// A whole file. Errors: missing, a folder, unreadable; each names the file and the reason.
Result<std::vector<std::uint8_t>, ImageError> readFile(const std::filesystem::path& file);

/// Replaces a file in one step: the content goes to a temporary name in the same folder, which then
/// takes the file's place. On failure the file is as it was and nothing else remains.
ImageOutcome writeFile(const std::filesystem::path& file, std::span<const std::uint8_t> content);

} // namespace aolib
