#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <aolib/Options.h>
#include <aolib/Status.h>
#include <glm/vec3.hpp>

#include "parallel/ParallelLoop.h"
#include "raytracing/RayScene.h"

namespace aolib {

/// How visibility is traced. Rays are spread over two jittered grids of m x m cells with
/// `m = ceil(sqrt(rays / 2))`, so a few more than asked for are traced; `raysTraced()` says how
/// many.
struct TraceSettings {
    int rays = 1024;                 ///< per receiver, 2 to 2^24
    double radius = 1.0;             ///< world units, above 0; `Falloff::Off` ignores it
    Falloff falloff = Falloff::Step; ///< weight of a hit by its distance
    std::uint64_t seed = 0;          ///< another seed, another noise
    int threads = 0;                 ///< workers, 0 takes one per core; does not change the result
};

/// A point on a surface whose visibility is traced.
struct Receiver {
    glm::dvec3 position{0.0}; ///< world units
    glm::dvec3 normal{0.0};   ///< any length but zero; the hemisphere above the surface
    double lift = -1.0; ///< how far along the normal rays start, world units; negative derives it
                        ///< from the rounding of float positions, `RayScene::clearance()`
};

/// Visibility at one receiver, and how sure it is.
struct VisibilityEstimate {
    double visibility = 1.0; ///< W, 0 closed to 1 open
    double variance = 0.0;   ///< squared standard error of `visibility`, estimated without bias
};

/// Visibility at many receivers.
struct VisibilityList {
    std::vector<float> visibility;    ///< W per receiver; -1 where cancelled before its turn
    std::vector<float> standardError; ///< of each W; a single one is itself uncertain
    double noise = 0.0;    ///< expected RMSE of W from sampling, over the traced receivers
    bool complete = false; ///< false when the progress callback cancelled
};

/// Ray-traced visibility `W = 1 - 1/pi * Int w(L) cos(theta) d omega` (DESIGN, sections 2 and 9),
/// the truth that estimators are measured against. Occluders are two-sided.
///
/// Noise: each cell of the grid over the cosine-weighted hemisphere holds two independent rays, one
/// of each of the two grids, with weights a and b. The mean over all has the variance
/// `Sum (a - b)^2 / (4 cells^2)` in expectation: no bias, because a and b are independent and
/// equally distributed. `noise` is the root of the mean of those variances over the receivers. Two
/// rays a cell cost some stratification: the error is up to 2^(1/4) = 1.19 times that of a single
/// grid with as many rays, which could not state its own.
class VisibilityTracer {
public:
    /// Errors: InvalidOption. The scene must outlive the tracer.
    static Result<VisibilityTracer> create(const RayScene& scene, const TraceSettings& settings);

    /// W at one receiver. `index` picks its random numbers. Threads: any.
    VisibilityEstimate estimate(const Receiver& receiver, std::uint64_t index) const;

    /// W at every receiver, random numbers by its place in the list.
    /// Errors: InvalidPosition, InvalidNormal (not finite or zero), naming the receiver.
    Result<VisibilityList> trace(std::span<const Receiver> receivers,
                                 const LoopProgress& progress = {}) const;

    int raysTraced() const { return 2 * cells_ * cells_; }
    const TraceSettings& settings() const { return settings_; }
    const RayScene& scene() const { return *scene_; }

private:
    VisibilityTracer(const RayScene& scene, const TraceSettings& settings);

    /// w(L) of the first hit along a ray, 0 when it escapes.
    double occlusion(const glm::dvec3& origin, const glm::dvec3& direction) const;

    const RayScene* scene_;
    TraceSettings settings_;
    int cells_; ///< along each side of the grid
};

/// The expected RMSE behind a list of standard errors: the root of the mean of their squares.
/// Negative ones are left out; 0 when none is left.
double noiseOf(std::span<const float> standardErrors);

} // namespace aolib
