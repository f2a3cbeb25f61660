#include "viewer/CubeMapGizmos.h"

#include <array>
#include <string>

#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <imgui.h>

namespace aolib::viewer {

namespace {

/// How near to a gizmo's centre the mouse must be, pixels.
constexpr float kReach = 14.0F;
constexpr ImU32 kColour = IM_COL32(60, 140, 255, 255);
constexpr ImU32 kChosen = IM_COL32(255, 170, 40, 255);
constexpr ImU32 kShadow = IM_COL32(0, 0, 0, 160);

ImVec2 vec(const glm::vec2& v) {
    return {v.x, v.y};
}

/// Nothing for what is behind the eye.
std::optional<glm::vec2> onPicture(const glm::vec3& position, const glm::mat4& viewProjection,
                                   const glm::vec2& size) {
    const glm::vec4 clip = viewProjection * glm::vec4(position, 1.0F);
    if (!(clip.w > 0.0F)) {
        return std::nullopt;
    }
    const glm::vec2 normalised = glm::vec2(clip) / clip.w;
    return glm::vec2(0.5F + 0.5F * normalised.x, 0.5F - 0.5F * normalised.y) * size;
}

glm::vec3 corner(const glm::vec3& centre, unsigned index, float edge) {
    const auto sign = [&](unsigned bit) { return (index & bit) != 0 ? 0.5F : -0.5F; };
    return centre + edge * glm::vec3(sign(1), sign(2), sign(4));
}

} // namespace

std::vector<Gizmo> gizmosOf(const std::vector<CubeMapInfo>& cubeMaps,
                            const glm::mat4& viewProjection, const glm::vec2& size, float edge) {
    std::vector<Gizmo> gizmos;
    for (const CubeMapInfo& cubeMap : cubeMaps) {
        Gizmo gizmo;
        gizmo.id = cubeMap.id;
        if (const auto centre = onPicture(cubeMap.position, viewProjection, size)) {
            gizmo.centre = *centre;
            gizmo.visible = true;
        }
        std::array<std::optional<glm::vec2>, 8> corners;
        for (unsigned i = 0; i < corners.size(); ++i) {
            corners[i] = onPicture(corner(cubeMap.position, i, edge), viewProjection, size);
        }
        for (unsigned i = 0; i < corners.size(); ++i) {
            for (const unsigned bit : {1U, 2U, 4U}) {
                const unsigned other = i | bit;
                if (other != i && corners[i] && corners[other]) {
                    gizmo.edges.push_back(*corners[i]);
                    gizmo.edges.push_back(*corners[other]);
                }
            }
        }
        gizmos.push_back(std::move(gizmo));
    }
    return gizmos;
}

std::optional<CubeMapId> gizmoAt(const std::vector<Gizmo>& gizmos, const glm::vec2& mouse) {
    std::optional<CubeMapId> found;
    float nearest = kReach;
    for (const Gizmo& gizmo : gizmos) {
        const float distance = glm::distance(gizmo.centre, mouse);
        if (gizmo.visible && distance <= nearest) {
            nearest = distance;
            found = gizmo.id;
        }
    }
    return found;
}

void drawGizmos(const std::vector<Gizmo>& gizmos, const glm::vec2& size,
                std::optional<CubeMapId> chosen) {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.PushClipRect({0.0F, 0.0F}, vec(size));
    for (const Gizmo& gizmo : gizmos) {
        const ImU32 colour = chosen == gizmo.id ? kChosen : kColour;
        for (std::size_t i = 0; i + 1 < gizmo.edges.size(); i += 2) {
            list.AddLine(vec(gizmo.edges[i]), vec(gizmo.edges[i + 1]), kShadow, 3.0F);
            list.AddLine(vec(gizmo.edges[i]), vec(gizmo.edges[i + 1]), colour, 1.5F);
        }
        if (gizmo.visible) {
            list.AddCircleFilled(vec(gizmo.centre), 4.0F, colour);
            const std::string name = std::to_string(static_cast<std::uint32_t>(gizmo.id));
            const ImVec2 at(gizmo.centre.x + 8.0F, gizmo.centre.y - 16.0F);
            list.AddText({at.x + 1.0F, at.y + 1.0F}, IM_COL32_BLACK, name.c_str());
            list.AddText(at, IM_COL32_WHITE, name.c_str());
        }
    }
    list.PopClipRect();
}

} // namespace aolib::viewer
