#pragma once

#include <span>
#include <vector>

#include <glm/vec4.hpp>

#include "bake/SurfaceSamples.h"
#include "bake/VertexWeld.h"

namespace aolib::bake {

/// For each welded vertex the mean of the samples of the triangles about it (GPU Gems, 17.2).
/// @param values  per sample: W, and the direction as xyz in the last three.
std::vector<glm::vec4> meanAboutVertices(const BakeGeometry& geometry, const VertexWeld& weld,
                                         std::span<const SurfaceSample> samples,
                                         std::span<const glm::vec4> values);

/// For each welded vertex the value x with which the linear interpolation over the triangles is
/// nearest to the samples: least `Sum area (Sum_k b_k x_k - value)^2` plus
/// `smoothness * Sum_edges area_edge (x_i - x_j)^2`, with an edge's share of its triangles' area
/// (after Kavan, Bargteil and Sloan 2011, whose second term compares gradients). Solved by
/// conjugate gradients.
std::vector<glm::vec4> fitVertices(const BakeGeometry& geometry, const VertexWeld& weld,
                                   std::span<const SurfaceSample> samples,
                                   std::span<const glm::vec4> values, double smoothness);

} // namespace aolib::bake
