#pragma once

#include <filesystem>
#include <string>

namespace aolib::bench {

/// Replaces a file by a text, whole or not at all. Returns why that failed, or an empty text.
std::string writeText(const std::filesystem::path& file, const std::string& text);

} // namespace aolib::bench
