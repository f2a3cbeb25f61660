#include "viewer/SplitLine.h"

#include <algorithm>
#include <cmath>

namespace aolib::viewer {

namespace {

/// How near the mouse must be to take hold, pixels.
constexpr float kGrabReach = 8.0F;
/// The line stays where it can be grasped, shares of the width.
constexpr float kEdgeMargin = 0.01F;

} // namespace

void SplitLine::place(float share) {
    share_ = std::clamp(share, kEdgeMargin, 1.0F - kEdgeMargin);
}

bool SplitLine::near(float x, float width) const {
    return std::abs(x - share_ * width) <= kGrabReach;
}

bool SplitLine::follow(const ButtonDrag& left, float width) {
    if (left.pressed) {
        dragging_ = near(left.from.x, width);
        grip_ = left.from.x - share_ * width;
    } else if (!held_) {
        dragging_ = false;
    }
    held_ = left.held;
    if (!dragging_ || !(width > 0.0F)) {
        return false;
    }
    const float before = share_;
    place((left.to.x - grip_) / width);
    return share_ != before;
}

} // namespace aolib::viewer
