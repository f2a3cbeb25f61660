#pragma once

#include <cstddef>
#include <vector>

#include "content/GltfDocument.h"
#include "content/LoadError.h"
#include "content/Model.h"
#include "scene/Finite.h"

namespace aolib {

/// The parts of one glTF mesh that hold triangles, not yet placed. Strips and fans become
/// triangles; points and lines are left out. `index` is in range.
Result<std::vector<ModelMesh>, LoadError> readGltfMesh(const GltfDocument& document,
                                                       std::size_t index);

} // namespace aolib
