#include "Proximity.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace aolib::test {
namespace {

float distanceToSegment(const glm::vec3& p, const glm::vec3& a, const glm::vec3& b) {
    const glm::vec3 along = b - a;
    const float squared = glm::dot(along, along);
    const float t =
        squared > 0.0F ? std::clamp(glm::dot(p - a, along) / squared, 0.0F, 1.0F) : 0.0F;
    return glm::distance(p, a + t * along);
}

float distanceToTriangle(const glm::vec3& p, const glm::vec3& a, const glm::vec3& b,
                         const glm::vec3& c) {
    const glm::vec3 normal = glm::cross(b - a, c - a);
    const bool above = glm::dot(glm::cross(b - a, p - a), normal) >= 0.0F &&
                       glm::dot(glm::cross(c - b, p - b), normal) >= 0.0F &&
                       glm::dot(glm::cross(a - c, p - c), normal) >= 0.0F;
    if (above && glm::length(normal) > 0.0F) {
        return std::abs(glm::dot(p - a, glm::normalize(normal)));
    }
    return std::min(
        {distanceToSegment(p, a, b), distanceToSegment(p, b, c), distanceToSegment(p, c, a)});
}

} // namespace

float distanceToSurface(const TriangleMesh& mesh, const glm::vec3& point, float limit) {
    float nearest = limit;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const glm::vec3& a = mesh.positions[mesh.indices[i]];
        const glm::vec3& b = mesh.positions[mesh.indices[i + 1]];
        const glm::vec3& c = mesh.positions[mesh.indices[i + 2]];
        const glm::vec3 low = glm::min(a, glm::min(b, c)) - nearest;
        const glm::vec3 high = glm::max(a, glm::max(b, c)) + nearest;
        if (point.x >= low.x && point.x <= high.x && point.y >= low.y && point.y <= high.y &&
            point.z >= low.z && point.z <= high.z) {
            nearest = std::min(nearest, distanceToTriangle(point, a, b, c));
        }
    }
    return nearest;
}

/// Moeller and Trumbore 1997, two-sided.
std::optional<float> firstHit(const TriangleMesh& mesh, const glm::vec3& origin,
                              const glm::vec3& direction) {
    std::optional<float> nearest;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const glm::vec3& a = mesh.positions[mesh.indices[i]];
        const glm::vec3 e1 = mesh.positions[mesh.indices[i + 1]] - a;
        const glm::vec3 e2 = mesh.positions[mesh.indices[i + 2]] - a;
        const glm::vec3 p = glm::cross(direction, e2);
        const float determinant = glm::dot(e1, p);
        if (determinant == 0.0F) {
            continue;
        }
        const glm::vec3 s = (origin - a) / determinant;
        const float u = glm::dot(s, p);
        const glm::vec3 q = glm::cross(s, e1);
        const float v = glm::dot(direction, q);
        const float t = glm::dot(e2, q);
        if (u >= 0.0F && v >= 0.0F && u + v <= 1.0F && t > 0.0F && (!nearest || t < *nearest)) {
            nearest = t;
        }
    }
    return nearest;
}

} // namespace aolib::test
