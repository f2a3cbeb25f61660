#pragma once

#include <glm/vec2.hpp>

#include "backbone/frame/HostCamera.h"

namespace aolib {

/// Camera and size of a frame: two frames of equal viewpoints show the same picture of an unchanged
/// scene.
struct Viewpoint {
    HostCamera camera;
    glm::ivec2 size; ///< pixels
    ClipConvention clip;

    bool operator==(const Viewpoint&) const = default;
};

} // namespace aolib
