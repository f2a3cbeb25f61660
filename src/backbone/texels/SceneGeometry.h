#pragma once

#include <map>
#include <memory>
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
    };
    /// A mesh as it stood when instances() was called.
    struct Instance {
        std::shared_ptr<const Piece> piece;
        glm::mat4 transform;
        Bounds bounds;            ///< world units
        std::uint32_t firstSolid; ///< solids of the instances before this one
    };
    using Instances = std::vector<Instance>;

    /// Uploads what is new or changed, drops what is gone.
    /// @param solids  whether solids are distinguished from open meshes. Errors: OutOfMemory.
    AoStatus update(const gl::Functions& gl, const Scene& scene,
                    const std::vector<Scene::Change>& changes, bool solids);
    /// Drops what changed, without uploading anything.
    void forget(const std::vector<Scene::Change>& changes);
    /// The scene as it is now, for whoever draws it over several frames: later changes leave what
    /// it holds as it is.
    std::shared_ptr<const Instances> instances(const Scene& scene) const;
    std::size_t bytes() const;

    /// The solids, numbered from 1 across all instances, that contain a point (world units).
    std::vector<float> enclosingSolids(const Scene& scene, const glm::vec3& point) const;

private:
    std::map<MeshId, std::shared_ptr<const Piece>> pieces_;
};

} // namespace aolib
