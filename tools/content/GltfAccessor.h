#pragma once

#include <cstdint>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "content/GltfDocument.h"
#include "content/LoadError.h"

namespace aolib {

/// The elements of a three-component accessor as floats: plain, interleaved, sparse, normalised or
/// quantised. Values may be infinite or NaN. Fails when any byte of it lies outside its buffer.
Result<std::vector<glm::vec3>, LoadError> readVectors(const GltfDocument& document, int accessor);

/// The same of a two-component accessor.
Result<std::vector<glm::vec2>, LoadError> readPairs(const GltfDocument& document, int accessor);

/// The same of four components, of one, and of 4x4 matrices.
Result<std::vector<glm::vec4>, LoadError> readQuads(const GltfDocument& document, int accessor);
Result<std::vector<float>, LoadError> readNumbers(const GltfDocument& document, int accessor);
Result<std::vector<glm::mat4>, LoadError> readMatrices(const GltfDocument& document, int accessor);

/// The elements of an accessor of indices, 8, 16 or 32 bits wide.
Result<std::vector<std::uint32_t>, LoadError> readIndices(const GltfDocument& document,
                                                          int accessor);

} // namespace aolib
