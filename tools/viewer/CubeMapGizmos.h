#pragma once

#include <optional>
#include <vector>

#include <aolib/Statistics.h>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

namespace aolib::viewer {

/// Where on the picture a cube map stands.
struct Gizmo {
    CubeMapId id{};
    glm::vec2 centre{};           ///< mouse pixels from the upper left corner
    std::vector<glm::vec2> edges; ///< pairs of ends of a wire cube's edges before the eye
    bool visible = false;         ///< its centre is before the eye
};

/// The cube maps as small wire cubes.
/// @param size  of the picture, mouse pixels.  @param edge  of a cube, world units.
std::vector<Gizmo> gizmosOf(const std::vector<CubeMapInfo>& cubeMaps,
                            const glm::mat4& viewProjection, const glm::vec2& size, float edge);

/// The cube map below the mouse, the nearest to it.
std::optional<CubeMapId> gizmoAt(const std::vector<Gizmo>& gizmos, const glm::vec2& mouse);

/// Draws them behind ImGui's windows, clipped to the picture; the chosen one stands out.
void drawGizmos(const std::vector<Gizmo>& gizmos, const glm::vec2& size,
                std::optional<CubeMapId> chosen);

} // namespace aolib::viewer
