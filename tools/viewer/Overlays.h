#pragma once

#include <string>

#include <glm/vec2.hpp>

#include "viewer/ViewerState.h"

namespace aolib::viewer {

/// The keys and what the mouse does, over the middle of the picture.
void drawHelp(const glm::vec2& size);

/// The line between two pictures, with a handle, and what is to its left and right.
void drawSplit(const SplitLine& split, const glm::vec2& size, const std::string& left,
               const std::string& right);

} // namespace aolib::viewer
