#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "scene/Mesh.h"

namespace aolib {

/// The meshes that occlude, by id, and a journal of what changed since a backbone last looked.
class Scene {
public:
    MeshId add(Mesh mesh);
    /// Errors: UnknownMesh.
    Status replace(MeshId id, Mesh mesh);
    Status move(MeshId id, const glm::mat4& transform);
    Status remove(MeshId id);

    const std::map<MeshId, Mesh>& meshes() const { return meshes_; }
    bool empty() const { return meshes_.empty(); }
    std::size_t triangleCount() const;
    /// World bounds of all meshes.
    const Bounds& bounds() const { return bounds_; }
    /// Distance to the nearest triangle and the direction away from it; for an empty scene
    /// infinite.
    struct Clearance {
        float distance;
        glm::vec3 away; ///< unit vector from the nearest point towards `from`, or its normal
    };
    Clearance clearance(const glm::vec3& from) const;

    /// A change: which mesh, and the world region that it touches, before and after together.
    struct Change {
        MeshId id;
        bool geometry; ///< the triangles themselves, not only where they stand
        Bounds region;
    };
    /// The changes since the last call, oldest first.
    std::vector<Change> takeChanges();

private:
    Status unknown(MeshId id) const;
    void update();

    std::map<MeshId, Mesh> meshes_;
    std::vector<Change> changes_;
    Bounds bounds_;
    std::uint32_t nextId_ = 1;
};

} // namespace aolib
