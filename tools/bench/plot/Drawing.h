#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include <glm/vec2.hpp>

namespace aolib::bench {

struct Colour {
    std::uint8_t r = 0;
    std::uint8_t g = 0;
    std::uint8_t b = 0;
};

// Shapes. Lengths are pixels of a drawing; x to the right, y downwards.

/// A line through points, with round ends and joints.
struct Polyline {
    std::vector<glm::dvec2> points;
    Colour colour;
    double width = 1.0;
    double dash = 0.0; ///< length of dashes and of the gaps between them; 0 for none
};

/// A filled convex polygon with an outline about it.
struct Polygon {
    std::vector<glm::dvec2> points;
    Colour fill;
    Colour outline;
    double outlineWidth = 0.0; ///< 0 for none
};

struct Disc {
    glm::dvec2 center{0.0};
    double radius = 1.0;
    Colour fill;
    Colour outline;
    double outlineWidth = 0.0; ///< 0 for none
};

enum class Anchor { Start, Middle, End };

struct Text {
    std::string text;
    glm::dvec2 position{0.0}; ///< on the baseline, where `anchor` says
    double size = 12.0;       ///< of the font
    Colour colour;
    Anchor anchor = Anchor::Start;
    bool upwards = false; ///< turned to read from bottom to top
    bool bold = false;
};

using Shape = std::variant<Polyline, Polygon, Disc, Text>;

/// A picture as a list of shapes, back to front, on white.
struct Drawing {
    double width = 0.0;
    double height = 0.0;
    std::vector<Shape> shapes;
};

} // namespace aolib::bench
