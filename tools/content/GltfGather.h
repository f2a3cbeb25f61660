#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "content/GltfContent.h"

namespace aolib {

/// Replaces the accessors of attributes by new ones whose element i is a copy of the old
/// `source[i]`. Fails on sparse accessors.
std::optional<LoadError> gatherVertices(GltfContent& content, GltfContent::Json& attributes,
                                        const std::vector<std::uint32_t>& source);

} // namespace aolib
