#pragma once

#include <cstdint>
#include <vector>

#include <aolib/AmbientOcclusion.h>

#include "content/Model.h"

namespace aolib::host {

/// Which normals of a model ambient occlusion is told.
enum class SceneNormals : std::uint8_t {
    Geometric, ///< none: aolib takes the triangles' own
    Model,     ///< the model's, where it has any
};

/// Hands every mesh of a model to `ao`, in order; meshes without triangles are left out.
/// Returns their ids. Errors: as AmbientOcclusion::addMesh(), NoScene when nothing was left.
Result<std::vector<MeshId>> describeScene(AmbientOcclusion& ao, const Model& model,
                                          SceneNormals normals);

} // namespace aolib::host
