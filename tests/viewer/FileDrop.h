#pragma once

#include <string>

namespace aolib::test {

/// Drops a file on a window, as a file manager does (XDND). Returns why that failed, or an empty
/// text when the window said that it has it.
/// @param display  ":3".  @param window  X's number.
std::string dropFile(const std::string& display, const std::string& window,
                     const std::string& file);

} // namespace aolib::test
