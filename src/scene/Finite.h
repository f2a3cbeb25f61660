#pragma once

#include <cmath>

#include <glm/vec3.hpp>

namespace aolib {

/// Neither NaN nor infinite in any component.
inline bool isFinite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

} // namespace aolib
