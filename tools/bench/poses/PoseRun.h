#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include <aolib/Status.h>

#include "content/MovingGltf.h"

namespace aolib::bench {

/// What is measured of a moving model: visibility of vertices between baked poses against fresh
/// bakes.
struct PosePlan {
    std::string name;
    const MovingGltf* model = nullptr;
    std::size_t animation = 0;
    std::vector<int> poses{2, 3, 5, 9}; ///< baked, evenly spaced over the animation
    int tests = 8;                      ///< times between, at the middles of as many parts
    int rays = 1024;                    ///< per vertex
};

/// A line of the table: RMSE of W over all vertices and tested times.
struct PoseRow {
    std::string name;
    std::size_t vertices = 0;
    int poses = 0;
    double rest = 0.0;         ///< of the model at rest, whatever the pose
    double byTime = 0.0;       ///< of poseWeightsAt()
    double byParameters = 0.0; ///< of poseWeightsFor(), from all that moves
    double noise = 0.0;        ///< between two fresh bakes
    /// Mean angle between bent normals, in the mesh's space at rest, and the fresh ones where W is
    /// between 0.1 and 0.9; degrees: of the model at rest, by time, and the noise.
    double restAngle = 0.0;
    double byTimeAngle = 0.0;
    double noiseAngle = 0.0;
};

/// Errors: those of poses and bakers. @param goOn  false ends the run: Cancelled.
Result<std::vector<PoseRow>> runPosePlan(const PosePlan& plan,
                                         const std::function<bool(double done)>& goOn);

/// The rows as a table in Markdown, as docs/baking.md shows them.
std::string poseMarkdown(const std::vector<PoseRow>& rows);

} // namespace aolib::bench
