#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include <aolib/BakeExport.h>
#include <aolib/Status.h>

namespace aolib::bake {

/// How much of each baked pose a moment between them takes: the two poses about it, linearly.
/// Weights sum to 1; before the first pose and after the last one those stand alone.
/// @param times  of the poses, any unit, growing, at least one.
/// Since 0.1.
AOLIB_BAKE_EXPORT std::vector<float> poseWeightsAt(std::span<const float> times, float time);

/// The same for poses that have no order: parameters (angles, morph weights) say which is near. The
/// weights rebuild the wanted parameters from those of the poses as well as sums of them can, in
/// the least squares, and prefer near ones where several sums do: at a pose they are it alone.
/// (Saul and Roweis 2003, "Think Globally, Fit Locally", section 2.) They sum to 1 and may be below
/// 0. Cost: the cube of the number of poses.
/// @param poses  at least one; each as long as `wanted`.
/// Errors: InvalidOption (no pose, lengths that differ, numbers that are not finite). Since 0.1.
AOLIB_BAKE_EXPORT Result<std::vector<float>>
poseWeightsFor(std::span<const std::vector<float>> poses, std::span<const float> wanted);

/// Visibility of vertices between poses: the weighted sum, cut to 0 and 1.
/// @param poses  visibility of each vertex in each pose, as many as there are weights, all of one
///               length.
/// Errors: InvalidOption. Since 0.1.
AOLIB_BAKE_EXPORT Result<std::vector<float>> blendPoses(std::span<const std::vector<float>> poses,
                                                        std::span<const float> weights);

/// Bent normals of vertices between poses: the weighted sum, made one unit long; where that is
/// zero, what the pose of the greatest weight has. They have to be in the space in which the mesh
/// is at rest, and are then transformed as normals are.
/// @param poses  as for blendPoses(), unit length.
/// Errors: InvalidOption. Since 0.1.
AOLIB_BAKE_EXPORT Result<std::vector<glm::vec3>>
blendPoseNormals(std::span<const std::vector<glm::vec3>> poses, std::span<const float> weights);

} // namespace aolib::bake
