#pragma once

#include <functional>
#include <span>
#include <vector>

#include <glm/vec4.hpp>

#include <aolib/Status.h>
#include <aolib/bake/BakeOptions.h>

#include "bake/geometry/SurfaceSamples.h"
#include "bake/vertices/VertexWeld.h"

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

/// The same with integrals over the surface in place of samples.
/// @param right  per number the integral of b_k times the value, square world units.
/// @param start  values to begin from.
std::vector<glm::vec4> fitIntegrals(const BakeGeometry& geometry, const VertexWeld& weld,
                                    const std::vector<glm::dvec4>& right,
                                    const std::vector<glm::vec4>& start, double smoothness);

/// W, and the direction as xyz in the last three, at places: by whatever method.
using ValuesAt =
    std::function<Result<std::vector<glm::vec4>>(const std::vector<SurfacePoint>& places)>;

/// A value for each welded vertex as the options say, from values at the places that they ask for.
/// Errors: those of `valuesAt`.
Result<std::vector<glm::vec4>> weldedValues(const BakeGeometry& geometry, const VertexWeld& weld,
                                            const VertexOptions& options, const ValuesAt& valuesAt);

} // namespace aolib::bake
