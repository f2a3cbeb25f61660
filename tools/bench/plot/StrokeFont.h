#pragma once

#include <string>
#include <vector>

#include <glm/vec2.hpp>

namespace aolib::bench {

/// How wide a text is in our own font and, nearly, in the usual sans serif ones; pixels.
double textWidth(const std::string& text, double size);

/// The strokes of a text that begins at the origin of the baseline; y downwards, pixels. Characters
/// outside ASCII are shown as boxes.
std::vector<std::vector<glm::dvec2>> textStrokes(const std::string& text, double size);

} // namespace aolib::bench
