#pragma once

#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace aolib {

/// Axis-aligned bounding box, world units. A fresh one is empty.
struct Bounds {
    glm::vec3 min{std::numeric_limits<float>::infinity()};
    glm::vec3 max{-std::numeric_limits<float>::infinity()};

    bool empty() const { return !(min.x <= max.x && min.y <= max.y && min.z <= max.z); }
    glm::vec3 center() const { return 0.5F * min + 0.5F * max; }
    /// Length of the diagonal, the "size" of a scene; 0 when empty.
    float diagonal() const { return empty() ? 0.0F : glm::distance(min, max); }

    void include(const glm::vec3& point) {
        min = glm::min(min, point);
        max = glm::max(max, point);
    }
    void include(const Bounds& other) {
        min = glm::min(min, other.min);
        max = glm::max(max, other.max);
    }
    Bounds inflated(float by) const { return empty() ? *this : Bounds{min - by, max + by}; }
    bool contains(const glm::vec3& p) const {
        return glm::all(glm::lessThanEqual(min, p)) && glm::all(glm::lessThanEqual(p, max));
    }
};

/// The axis-aligned box about the eight transformed corners of `box`.
inline Bounds transformed(const Bounds& box, const glm::mat4& matrix) {
    Bounds result;
    if (box.empty()) {
        return result;
    }
    for (int corner = 0; corner < 8; ++corner) {
        const glm::vec3 p{(corner & 1) != 0 ? box.max.x : box.min.x,
                          (corner & 2) != 0 ? box.max.y : box.min.y,
                          (corner & 4) != 0 ? box.max.z : box.min.z};
        result.include(glm::vec3(matrix * glm::vec4(p, 1.0F)));
    }
    return result;
}

} // namespace aolib
