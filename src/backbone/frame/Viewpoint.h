#pragma once

#include <glm/vec2.hpp>

#include "backbone/frame/HostCamera.h"

namespace aolib {

/// What a frame is seen through, and its size: two frames of equal viewpoints show the same, if the
/// scene is the same.
struct Viewpoint {
    HostCamera camera;
    glm::ivec2 size; ///< pixels
    ClipConvention clip;

    bool operator==(const Viewpoint&) const = default;
};

} // namespace aolib
