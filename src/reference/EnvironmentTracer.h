#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <aolib/Status.h>
#include <aolib/lighting/EnvironmentMap.h>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "parallel/ParallelLoop.h"
#include "raytracing/RayScene.h"
#include "reference/VisibilityTracer.h"

namespace aolib {

/// Directions with a density in proportion to a map's brightness.
class EnvironmentSampler {
public:
    /// The map must be good and outlive the sampler.
    explicit EnvironmentSampler(const lighting::EnvironmentMap& map);

    struct Sample {
        glm::dvec3 direction{0.0}; ///< unit length
        double density = 0.0;      ///< per steradian; 0 for a map without any light
        glm::dvec3 radiance{0.0};
    };
    /// @param square  uniform in the unit square.
    Sample sample(const glm::dvec2& square) const;
    /// What a direction of unit length, come by otherwise, would have had.
    Sample at(const glm::dvec3& direction) const;

private:
    Sample texel(int x, int y, const glm::dvec3& direction) const;

    const lighting::EnvironmentMap& map_;
    std::vector<double> rows_;    ///< sums of brightness over rows up to and with this one
    std::vector<double> columns_; ///< the same along each row
};

/// How light is traced. Half of the rays follow the cosine, half the environment's brightness,
/// weighed by the balance heuristic (Veach 1997).
struct LightSettings {
    int rays = 1024;        ///< per receiver, 8 to 2^24; rounded up to 4 times a square
    std::uint64_t seed = 0; ///< another seed, another noise
    int threads = 0;        ///< workers, 0 takes one per core; does not change the result
};

/// Light that white diffuse receivers send out.
struct LightList {
    std::vector<glm::vec3> radiance; ///< in the map's unit; -1 where cancelled before its turn
    double noise = 0.0;    ///< expected RMSE from sampling, mean of the three channels' squares
    bool complete = false; ///< false when the progress callback cancelled
};

/// The radiance of white diffuse surfaces under an environment, `1/pi * Int V L cos(theta) d
/// omega`, without light from one surface to another: the truth of environment lighting. Errors:
/// InvalidOption, InvalidPosition, InvalidNormal.
Result<LightList> traceEnvironment(const RayScene& scene, const lighting::EnvironmentMap& map,
                                   std::span<const Receiver> receivers,
                                   const LightSettings& settings,
                                   const LoopProgress& progress = {});

} // namespace aolib
