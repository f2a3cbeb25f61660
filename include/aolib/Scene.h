#pragma once

#include <cstdint>
#include <span>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace aolib {

/// How a run of vertex indices forms faces, as in OpenGL; the thesis's names (4.7.1).
enum AoPrimitive : std::uint8_t {
    AO_TRIANGLES,
    AO_TRIANGLE_STRIP,
    AO_TRIANGLE_FAN,
    AO_QUADS,
    AO_QUAD_STRIP,
};

/// Identifies a mesh while it is part of the scene. An instance never reuses an id.
enum class MeshId : std::uint32_t {};

/// Identifies a cube map while it exists. An instance never reuses an id.
enum class CubeMapId : std::uint32_t {};

/// A mesh as arrays. The spans are read during the call and not kept.
struct MeshData {
    std::span<const glm::vec3> positions;   ///< model space
    std::span<const glm::vec3> normals;     ///< empty, or one per position; any length but zero
    std::span<const std::uint32_t> indices; ///< triangles, three each
    glm::mat4 transform{1.0F};              ///< model to world, affine
};

} // namespace aolib
