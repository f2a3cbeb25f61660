#pragma once

#include <memory>

#include <aolib/ProcAddressLoader.h>
#include <aolib/bake/AbstractBaker.h>

#include "bake/BakeGeometry.h"
#include "bake/LightView.h"
#include "gl/Functions.h"

namespace aolib::bake {

/// What every baker on the GPU has.
struct GpuBake {
    std::unique_ptr<gl::Functions> gl; ///< in one place: GL objects refer to it
    BakeGeometry geometry;
    BakeFrame frame;

    /// Errors: those of BakeGeometry::create() and gl::Functions::load().
    static Result<GpuBake> create(const ProcAddressLoader& loader, BakeScene scene);

    /// Up and the ground's height along it, in the frame; 0 where there is no ground.
    glm::vec4 ground() const;
};

/// Visibility per unit of summed cosines of all directions of a sky: a point that no direction is
/// closed to gets 1, but for what the directions miss of the integral.
double cosineNorm(Sky sky, int directions);

/// Turns sums (weighed direction, weight) of texels into a map's values; W may yet exceed 1.
/// @param norm  visibility per weight.
void setTexel(BakedMap& map, std::size_t texel, const glm::vec4& sum, double norm,
              const glm::dvec3& normal);

} // namespace aolib::bake
