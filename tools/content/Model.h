#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "scene/Bounds.h"
#include "scene/TriangleMesh.h"

namespace aolib {

/// Where in a glTF a mesh comes from: numbers of its JSON, -1 where there is none.
struct GltfOrigin {
    int node = -1;
    int mesh = -1;
    int primitive = -1;
    int material = -1;
};

/// One drawable piece of a model: triangles, a colour and a place. Instances of a shared mesh are
/// copies.
struct ModelMesh {
    std::string name;
    std::vector<glm::vec3> positions;   ///< before `transform`, finite
    std::vector<glm::vec3> normals;     ///< before `transform`, unit; empty or as many as positions
    std::vector<std::uint32_t> indices; ///< triangles, counter-clockwise seen from outside
    glm::vec4 baseColour{1.0F};         ///< linear RGBA, 0 to 1
    glm::mat4 transform{1.0F};          ///< model to world, affine
    bool doubleSided = false;
    GltfOrigin origin;

    std::size_t triangleCount() const { return indices.size() / 3; }
};

/// What a file or a generator gives: meshes in one world.
struct Model {
    std::string name; ///< stem of the file, or the name of the generated scene
    std::vector<ModelMesh> meshes;

    /// World bounds of the vertices that triangles use.
    Bounds bounds() const;
    std::size_t triangleCount() const;
    /// All triangles in world space. Mirroring transforms flip the winding; normals go through the
    /// inverse transpose; zero ones stay, which means that the triangle's own counts. Where only
    /// some meshes have normals, the others get their faces' normals (their vertices are then no
    /// longer shared between triangles).
    TriangleMesh flattened() const;
};

/// Area-weighted unit normals of a mesh's vertices, as long as `positions`; +Y where a vertex has
/// no triangle with an area.
std::vector<glm::vec3> smoothNormals(const std::vector<glm::vec3>& positions,
                                     const std::vector<std::uint32_t>& indices);

} // namespace aolib
