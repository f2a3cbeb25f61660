#pragma once

#include <filesystem>
#include <string>

namespace aolib::viewer {

/// The first of "aolib-view-001.png", "aolib-view-002.png" ... that a folder does not have.
std::filesystem::path nextNumberedFile(const std::filesystem::path& folder,
                                       const std::string& ending);

} // namespace aolib::viewer
