#pragma once

#include <map>
#include <optional>
#include <vector>

#include <aolib/Status.h>

#include "gl/VertexArray.h"
#include "scene/Scene.h"
#include "scene/Solids.h"

namespace aolib {

/// The scene's triangles in GPU memory, mesh by mesh.
class SceneGeometry {
public:
    struct Piece {
        gl::VertexArray triangles;
        std::optional<Solids> solids; ///< found when an estimator needs them
        std::uint32_t firstSolid = 0; ///< solids of the pieces before this one
    };

    /// Uploads what is new or changed, drops what is gone.
    /// @param solids  whether the pieces must tell solids from sheets. Errors: OutOfMemory.
    AoStatus update(const gl::Functions& gl, const Scene& scene,
                    const std::vector<Scene::Change>& changes, bool solids);
    /// Drops what changed, without uploading anything.
    void forget(const std::vector<Scene::Change>& changes);
    const Piece& piece(MeshId id) const { return pieces_.at(id); }
    std::size_t bytes() const;

    /// The solids, numbered from 1 across all pieces, that contain a point (world units).
    std::vector<float> solidsAround(const Scene& scene, const glm::vec3& point) const;

private:
    std::map<MeshId, Piece> pieces_;
};

} // namespace aolib
