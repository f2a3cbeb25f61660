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
    AoStatus replace(MeshId id, Mesh mesh);
    AoStatus move(MeshId id, const glm::mat4& transform);
    AoStatus remove(MeshId id);

    const std::map<MeshId, Mesh>& meshes() const { return meshes_; }
    /// Whether there is nothing: no mesh, and nothing that the host draws.
    bool empty() const { return meshes_.empty() && drawn_.empty(); }
    std::size_t triangleCount() const;
    /// World bounds of all meshes, and of what the host draws.
    const Bounds& bounds() const { return bounds_; }
    /// Says that the host draws the scene by itself, within a box; an empty box ends that.
    void setDrawn(const Bounds& box);
    bool drawn() const { return !drawn_.empty(); }
    /// Says that something changed in a region that no mesh tells of.
    void touch(const Bounds& region) { changes_.push_back({MeshId{0}, false, region}); }

    /// Distance to the nearest triangle and the direction away from it; for an empty scene
    /// infinite.
    struct Clearance {
        float distance;
        glm::vec3 away; ///< unit vector from the nearest point towards `from`, or its normal
    };
    Clearance clearance(const glm::vec3& from) const;

    /// A change: which mesh (0: none), and the world region that it touches, before and after
    /// together.
    struct Change {
        MeshId id;
        bool geometry; ///< the triangles themselves, not only where they stand
        Bounds region;
    };
    /// The changes since the last call, oldest first.
    std::vector<Change> takeChanges();

private:
    AoStatus unknown(MeshId id) const;
    void update();

    std::map<MeshId, Mesh> meshes_;
    std::vector<Change> changes_;
    Bounds bounds_;
    Bounds drawn_;
    std::uint32_t nextId_ = 1;
};

} // namespace aolib
