#pragma once

#include <string>

#include <glm/vec2.hpp>

#include "viewer/ViewerState.h"

namespace aolib::viewer {

/// The keys and what the mouse does, over the middle of the picture; where that is too narrow, of
/// the window. @param picture,window  mouse pixels.
void drawHelp(const glm::vec2& picture, const glm::vec2& window);

/// The line between two pictures, with a handle, and what is to its left and right.
void drawSplit(const SplitLine& split, const glm::vec2& size, const std::string& left,
               const std::string& right);

} // namespace aolib::viewer
