#pragma once

#include <optional>

#include <aolib/Scene.h>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "content/NamedCamera.h"

namespace aolib::viewer {

/// The mark of a cube map, and the mouse that drags it. The cube map itself stays where it is
/// until the mark is let go.
class GizmoDrag {
public:
    /// How a mark follows the mouse.
    enum class Along {
        Plane, ///< stays below the mouse, as far before the eye as it was
        Ray,   ///< stays where it is on the picture: up is farther, down is nearer
    };
    struct Move {
        CubeMapId id{};
        glm::vec3 to{0.0F}; ///< world units
    };

    /// The button went down on a mark.
    /// @param position  of the cube map, world units.  @param mouse  pixels.
    void begin(CubeMapId id, const glm::vec3& position, const glm::vec2& mouse);
    /// The mouse is elsewhere. @param size  of the picture, mouse pixels.
    void follow(const glm::vec2& mouse, Along along, const NamedCamera& camera,
                const glm::vec2& size);
    /// The button is up again: what to move, nothing where the mark was only clicked.
    std::optional<Move> end();
    /// Nothing is moved, whatever the mouse does until the next begin().
    void cancel() { move_.reset(); }

    /// Where the mark is drawn instead of where the cube map stands, if it is dragged.
    std::optional<Move> current() const;
    const glm::vec3& from() const { return from_; } ///< world units

private:
    std::optional<Move> move_;
    glm::vec3 from_{0.0F};
    glm::vec2 pressed_{0.0F}; ///< where the button went down, pixels
    glm::vec2 mouse_{0.0F};   ///< pixels
    bool moved_ = false;      ///< farther than a hand trembles
};

} // namespace aolib::viewer
