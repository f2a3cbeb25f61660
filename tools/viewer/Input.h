#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace aolib::viewer {

/// A key that went down: GLFW's number, and whether Control or Shift was held.
struct KeyPress {
    int key = 0;
    bool control = false;
    bool shift = false;
};

enum class MouseButton : std::uint8_t { Left, Right, Middle };

/// What mouse and keyboard did to the picture since the last frame; what the panels took is left
/// out. Mouse pixels, right and down are positive.
struct Input {
    std::array<glm::vec2, 3> drag{};  ///< by MouseButton, of those that went down on the picture
    std::array<bool, 3> pressed{};    ///< went down on the picture
    std::array<bool, 3> held{};       ///< went down on the picture and is still
    glm::vec2 mouse{};                ///< where it is, from the upper left corner
    float wheel = 0.0F;               ///< notches, away from the user is positive
    glm::vec3 walk{0.0F};             ///< keys held: to the right, up, ahead, each -1 to 1
    bool fast = false;                ///< Shift is held
    std::vector<KeyPress> keys;       ///< in order
    std::vector<std::string> dropped; ///< files

    const glm::vec2& dragOf(MouseButton button) const {
        return drag[static_cast<std::size_t>(button)];
    }
};

} // namespace aolib::viewer
