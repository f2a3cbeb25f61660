// What the mouse does to the marks of cube maps.
#include <algorithm>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "viewer/Viewer.h"

namespace aolib::viewer {

namespace {

/// Edges of the marks, shares of the scene's diagonal.
constexpr float kGizmoShare = 0.008F;

} // namespace

void Viewer::followGizmos(const Input& input) {
    const ButtonDrag& left = input.of(MouseButton::Left);
    const std::vector<CubeMapInfo> cubeMaps = scene_->ao().cubeMaps();
    const auto stands = [&](CubeMapId id) {
        return std::ranges::find(cubeMaps, id, &CubeMapInfo::id);
    };
    const auto mark = gizmoAt(gizmos_, left.from);
    if (left.pressed && mark && !grabbed_ && stands(*mark) != cubeMaps.end()) {
        state_.chosen = mark;
        drag_.begin(*mark, stands(*mark)->position, left.from);
        grabbed_ = true;
    }
    const bool escaped = std::ranges::count(input.keys, GLFW_KEY_ESCAPE, &KeyPress::key) > 0;
    const auto dragged = drag_.current();
    if (escaped || (dragged && stands(dragged->id) == cubeMaps.end())) {
        drag_.cancel();
    }
    drag_.follow(left.to, input.fast ? GizmoDrag::Along::Ray : GizmoDrag::Along::Plane,
                 state_.camera.camera(), pictureSize());
    if (!left.held) {
        if (const auto move = drag_.end()) {
            moveCubeMap(*move);
        }
    }
}

/// Placed anew: what it held was seen from elsewhere.
void Viewer::moveCubeMap(const GizmoDrag::Move& move) {
    AmbientOcclusion& ao = scene_->ao();
    if (const AoStatus removed = ao.removeCubeMap(move.id); !removed) {
        return messages_.warn(removed.message());
    }
    Result<CubeMapId> placed = ao.addCubeMap(move.to);
    if (!placed) {
        messages_.warn(placed.status().message());
        placed = ao.addCubeMap(drag_.from());
    }
    state_.chosen.reset();
    if (placed) {
        state_.chosen = *placed;
    }
    scene_->touch();
    picture_.forget();
}

void Viewer::drawMarks(const glm::vec2& size) {
    gizmos_.clear();
    if (!state_.gizmos) {
        return;
    }
    std::vector<CubeMapInfo> cubeMaps = scene_->ao().cubeMaps();
    if (const auto dragged = drag_.current()) {
        const auto found = std::ranges::find(cubeMaps, dragged->id, &CubeMapInfo::id);
        if (found != cubeMaps.end()) {
            found->position = dragged->to;
        }
    }
    const glm::mat4 viewProjection = projectionMatrix(state_.camera.camera(), size.x / size.y) *
                                     viewMatrix(state_.camera.camera());
    const auto edge = kGizmoShare * static_cast<float>(scene_->view().diagonal);
    gizmos_ = gizmosOf(cubeMaps, viewProjection, size, edge);
    drawGizmos(gizmos_, size, state_.chosen);
}

} // namespace aolib::viewer
