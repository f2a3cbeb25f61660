#pragma once

#include <vector>

#include "bake/geometry/BakeGeometry.h"

namespace aolib::bake {

/// A sample of a surface.
struct SurfaceSample {
    TriangleName triangle;
    float b1 = 0.0F;   ///< barycentric weight of the triangle's second vertex
    float b2 = 0.0F;   ///< ... and of its third
    float area = 0.0F; ///< that it stands for, square world units
};

/// The centre of each triangle with an area, of all surfaces that do not only occlude.
std::vector<SurfaceSample> triangleCentres(const BakeGeometry& geometry);

/// The middles of each triangle's edges, each for a third of the triangle: sums over them are the
/// integrals of what is quadratic on the triangles.
std::vector<SurfaceSample> edgeMiddles(const BakeGeometry& geometry);

/// Samples spread evenly: as many per triangle as its share of the area says, at least one.
/// @param density  samples per triangle, on average.
std::vector<SurfaceSample> spreadSamples(const BakeGeometry& geometry, double density);

} // namespace aolib::bake
