#pragma once

#include <cstdint>

#include <aolib/Options.h>
#include <glm/vec3.hpp>

#include "raytracing/RayScene.h"
#include "reference/VisibilityTracer.h"
#include "scene/TriangleMesh.h"

namespace aolib::test {

/// Appends the parallelogram `corner, corner + a, corner + a + b, corner + b`, normal `a x b`.
void addQuad(TriangleMesh& mesh, const glm::dvec3& corner, const glm::dvec3& a,
             const glm::dvec3& b);

/// A floor at y = 0 and, along x = 0, a wall of the given height, both long enough that a wall's
/// end is worth less than 1e-6 of occlusion at distance 1. Everything times `scale` plus `offset`.
TriangleMesh floorAndWall(double height, double scale = 1.0,
                          const glm::dvec3& offset = glm::dvec3(0.0));

/// A regular polygon of 2048 sides with a disc's area, about the y axis at the given height, facing
/// down; up when `facingUp`.
TriangleMesh disc(double radius, double height, bool facingUp = false);

/// A sphere about the origin of 256 x 512 facets, normals outward.
TriangleMesh sphere(double radius);

/// The same of few facets, which look round by the normals at their corners.
TriangleMesh smoothSphere(double radius, std::uint32_t rows, std::uint32_t columns);

/// The box from -1 to 1, normals outward.
TriangleMesh box();

/// A scene or a test that ends here.
RayScene sceneOf(TriangleMesh mesh);

/// W at one receiver.
VisibilityEstimate visibilityAt(const RayScene& scene, const Receiver& receiver,
                                const TraceSettings& settings);

/// Shorthand for settings.
TraceSettings tracing(int rays, Falloff falloff = Falloff::Off, double radius = 1.0);

} // namespace aolib::test
