#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include <aolib/BakeExport.h>
#include <aolib/Status.h>

namespace aolib::bake {

/// Returns the weight of each baked pose at a time: linear between the two poses about it. Weights
/// sum to 1. Before the first pose and after the last one, that pose alone has weight 1.
/// @param times  of the poses, any unit, increasing, at least one.
/// Since 0.1.
AOLIB_BAKE_EXPORT std::vector<float> poseWeightsAt(std::span<const float> times, float time);

/// Returns the weight of each baked pose for given parameters (angles, morph weights), whatever the
/// order of poses. The weighted sum of the poses' parameters is the least-squares fit to the wanted
/// ones. If several sums fit equally well, nearer poses weigh more; at a pose, it alone has weight
/// 1 (Saul and Roweis 2003, "Think Globally, Fit Locally", section 2). Weights sum to 1 and may be
/// negative. Cost: the cube of the number of poses.
/// @param poses  at least one; each as long as `wanted`.
/// Errors: InvalidOption (no pose, lengths that differ, numbers that are not finite). Since 0.1.
AOLIB_BAKE_EXPORT Result<std::vector<float>>
poseWeightsFor(std::span<const std::vector<float>> poses, std::span<const float> wanted);

/// Returns the visibility of vertices between poses: the weighted sum, clamped to [0,1].
/// @param poses  visibility of each vertex in each pose, as many as there are weights, all of one
///               length.
/// Errors: InvalidOption. Since 0.1.
AOLIB_BAKE_EXPORT Result<std::vector<float>> blendPoses(std::span<const std::vector<float>> poses,
                                                        std::span<const float> weights);

/// Returns the bent normals of vertices between poses: the weighted sum, normalised. Where the sum
/// is zero, it is the bent normal of the pose with the greatest weight. Input and output lie in the
/// space of the mesh at rest; transform the output as normals are.
/// @param poses  as for blendPoses(), unit length.
/// Errors: InvalidOption. Since 0.1.
AOLIB_BAKE_EXPORT Result<std::vector<glm::vec3>>
blendPoseNormals(std::span<const std::vector<glm::vec3>> poses, std::span<const float> weights);

} // namespace aolib::bake
