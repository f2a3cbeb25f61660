#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "parallel/ParallelLoop.h"
#include "raytracing/RayScene.h"
#include "reference/VisibilityTracer.h"

namespace aolib {

/// What can be seen from a receiver, in few numbers: what bakers keep.
struct Opening {
    float visibility = 1.0F;         ///< W, by the cosine
    glm::vec3 bentNormal{0.0F};      ///< mean open direction by the cosine, unit; 0 if all closed
    float share = 1.0F;              ///< of the hemisphere's directions that are open
    glm::vec3 meanDirection{0.0F};   ///< of the open ones, unit; 0 if all closed
    std::array<float, 24> sectors{}; ///< open share of each sector by the cosine; W where no ray
                                     ///< went (shaders/shared/open_sector.h)
};

/// The openings of receivers, whose normals are unit length, by `rays` (at least 1; rounded up to a
/// square) rays each, spread evenly over solid angle. Occluders have no end and are two-sided.
std::vector<Opening> traceOpenings(const RayScene& scene, std::span<const Receiver> receivers,
                                   int rays, std::uint64_t seed, const LoopProgress& progress = {});

} // namespace aolib
