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

    /// @param number  0 to 7: bits 0, 1 and 2 choose between min and max of x, y and z.
    glm::vec3 corner(unsigned number) const {
        return {(number & 1U) != 0 ? max.x : min.x, (number & 2U) != 0 ? max.y : min.y,
                (number & 4U) != 0 ? max.z : min.z};
    }

    void include(const glm::vec3& point) {
        min = glm::min(min, point);
        max = glm::max(max, point);
    }
    void include(const Bounds& other) {
        min = glm::min(min, other.min);
        max = glm::max(max, other.max);
    }
    /// Distances of its nearest and farthest point from a point; of a box that is not empty.
    float nearest(const glm::vec3& from) const {
        return glm::distance(from, glm::clamp(from, min, max));
    }
    float farthest(const glm::vec3& from) const {
        return glm::length(glm::max(glm::abs(min - from), glm::abs(max - from)));
    }
    Bounds inflated(float by) const { return empty() ? *this : Bounds{min - by, max + by}; }
    /// Whether they share a point; an empty one shares none.
    bool meets(const Bounds& other) const {
        return glm::all(glm::lessThanEqual(min, other.max)) &&
               glm::all(glm::lessThanEqual(other.min, max));
    }
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
    for (unsigned corner = 0; corner < 8; ++corner) {
        result.include(glm::vec3(matrix * glm::vec4(box.corner(corner), 1.0F)));
    }
    return result;
}

} // namespace aolib
