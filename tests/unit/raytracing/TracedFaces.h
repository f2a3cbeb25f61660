#pragma once

#include <cstddef>
#include <functional>

#include <aolib/AbstractTexelTracer.h>
#include <glm/vec3.hpp>

#include "raytracing/RequestTracer.h"

namespace aolib::test {

/// The whole of a small face.
TexelRequest faceRequest(const glm::dvec3& centre, int face, int rays,
                         Falloff falloff = Falloff::Off, double radius = 1.0, int size = 8);

/// A request's result, or a test that fails.
TracedTexels traced(const RayScene& scene, const TexelRequest& request);

/// The face's camera, written out by hand.
glm::dvec3 directionOf(int face, int size, int x, int y);

/// Calls for every texel that sees something: its place, and the ray through its centre.
void forEachSeen(const TracedTexels& texels,
                 const std::function<void(std::size_t, const glm::dvec3&)>& call);

/// How many texels see something.
std::size_t seenCount(const TracedTexels& texels);

/// RMSE of a result against the truth with 16384 rays at what the texels see.
double errorAgainstTruth(const RayScene& scene, const TracedTexels& texels);

} // namespace aolib::test
