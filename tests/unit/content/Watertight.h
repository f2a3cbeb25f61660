#pragma once

#include <cstddef>

#include "content/Model.h"

namespace aolib::test {

/// How many edges, welded by exact position, are not run through as often one way as the other: 0
/// for a closed mesh whose faces all look the same way.
std::size_t unbalancedEdges(const ModelMesh& mesh);

/// The volume that a closed mesh encloses, positive when its faces look outwards.
double signedVolume(const ModelMesh& mesh);

} // namespace aolib::test
