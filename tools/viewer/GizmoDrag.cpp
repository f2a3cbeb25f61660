#include "viewer/GizmoDrag.h"

#include <cmath>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "viewer/CameraFrame.h"

namespace aolib::viewer {

namespace {

/// Less is a click, pixels.
constexpr float kSlack = 3.0F;
/// How many times as far a drag over the picture's height goes: e to this.
constexpr double kFarPerHeight = 3.0;

} // namespace

void GizmoDrag::begin(CubeMapId id, const glm::vec3& position, const glm::vec2& mouse) {
    move_ = Move{id, position};
    from_ = position;
    pressed_ = mouse_ = mouse;
    moved_ = false;
}

void GizmoDrag::follow(const glm::vec2& mouse, Along along, const NamedCamera& camera,
                       const glm::vec2& size) {
    moved_ = moved_ || glm::distance(mouse, pressed_) > kSlack;
    if (!move_ || !moved_) {
        return; // what the hand did before counts later
    }
    const glm::dvec2 pixels(mouse - mouse_);
    mouse_ = mouse;
    const CameraFrame frame(camera);
    const glm::dvec3 eye(camera.eye);
    const glm::dvec3 arm = glm::dvec3(move_->to) - eye;
    const auto height = static_cast<double>(size.y);
    if (along == Along::Ray) {
        move_->to = glm::vec3(eye + std::exp(-kFarPerHeight * pixels.y / height) * arm);
        return;
    }
    const double slope = std::tan(0.5 * glm::radians(static_cast<double>(camera.fovyDeg)));
    const double perPixel = 2.0 * slope * glm::dot(arm, frame.forward) / height;
    move_->to = glm::vec3(eye + arm + perPixel * (pixels.x * frame.right - pixels.y * frame.above));
}

std::optional<GizmoDrag::Move> GizmoDrag::end() {
    const std::optional<Move> done = current();
    move_.reset();
    return done;
}

std::optional<GizmoDrag::Move> GizmoDrag::current() const {
    return moved_ ? move_ : std::nullopt;
}

} // namespace aolib::viewer
