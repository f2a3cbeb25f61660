#pragma once

#include <span>
#include <vector>

#include "bake/geometry/BakeGeometry.h"
#include "bake/scatter/MapStack.h"
#include "bake/scatter/PointShape.h"
#include "bake/scatter/PointTarget.h"

namespace aolib::bake {

/// What of each texel charts cover, as scattered points see it: the sum of their shares in points
/// that lie evenly over the charts, `places` in each texel's area, each as large as its triangle's
/// are. A texel that is covered as a whole has 1.
/// @param shapes  of the triangles, by number.
std::vector<float> chartCoverage(const BakeGeometry& geometry, std::span<const PointShape> shapes,
                                 const MapStack& stack, const PointTarget& target, int places);

} // namespace aolib::bake
