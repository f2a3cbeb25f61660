#pragma once

#include <filesystem>
#include <string>

#include "content/LoadError.h"

namespace aolib {

/// The whole of a regular file, at most 2 GiB. Fails with a sentence on folders, devices, files
/// that cannot be opened, and read errors.
Result<std::string, LoadError> readFileBytes(const std::filesystem::path& file);

} // namespace aolib
