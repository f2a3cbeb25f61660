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

/// What a button did since the last frame: all of it, even where one frame saw it go down, move and
/// come up again. Mouse pixels from the picture's upper left corner, right and down are positive.
struct ButtonDrag {
    bool pressed = false; ///< it went down on the picture
    bool held = false;    ///< it went down on the picture and is still
    glm::vec2 from{};     ///< where it went down, if it did
    glm::vec2 to{};       ///< where it is held or was let go
    glm::vec2 by{};       ///< how far it was moved while it was down
};

/// What mouse and keyboard did to the picture since the last frame; what the panels took is left
/// out.
struct Input {
    std::array<ButtonDrag, 3> drags;  ///< by MouseButton
    float wheel = 0.0F;               ///< notches, away from the user is positive
    glm::vec3 walk{0.0F};             ///< keys held: to the right, up, ahead, each -1 to 1
    bool fast = false;                ///< Shift is held
    std::vector<KeyPress> keys;       ///< in order
    std::vector<std::string> dropped; ///< files

    const ButtonDrag& of(MouseButton button) const {
        return drags[static_cast<std::size_t>(button)];
    }
};

} // namespace aolib::viewer
