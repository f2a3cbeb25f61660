#pragma once

#include <optional>

#include <glm/vec3.hpp>

#include "scene/TriangleMesh.h"

namespace aolib::test {

/// The distance from a point to the nearest triangle, or `limit` where there is none so near.
float distanceToSurface(const TriangleMesh& mesh, const glm::vec3& point, float limit);

/// The distance along a ray of unit direction to its first hit.
std::optional<float> firstHit(const TriangleMesh& mesh, const glm::vec3& origin,
                              const glm::vec3& direction);

} // namespace aolib::test
