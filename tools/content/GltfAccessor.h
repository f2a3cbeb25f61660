#pragma once

#include <cstdint>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "content/GltfDocument.h"
#include "content/Loaded.h"

namespace aolib {

/// The elements of a three-component accessor as floats: plain, interleaved, sparse, normalised or
/// quantised. Values may be infinite or NaN. Fails when any byte of it lies outside its buffer.
Loaded<std::vector<glm::vec3>> readVectors(const GltfDocument& document, int accessor);

/// The same of a two-component accessor.
Loaded<std::vector<glm::vec2>> readPairs(const GltfDocument& document, int accessor);

/// The same of four components, of one, and of 4x4 matrices.
Loaded<std::vector<glm::vec4>> readQuads(const GltfDocument& document, int accessor);
Loaded<std::vector<float>> readNumbers(const GltfDocument& document, int accessor);
Loaded<std::vector<glm::mat4>> readMatrices(const GltfDocument& document, int accessor);

/// The elements of an accessor of indices, 8, 16 or 32 bits wide.
Loaded<std::vector<std::uint32_t>> readIndices(const GltfDocument& document, int accessor);

} // namespace aolib
