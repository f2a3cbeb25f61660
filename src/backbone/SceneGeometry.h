#pragma once

#include <map>
#include <vector>

#include <aolib/Status.h>

#include "gl/VertexArray.h"
#include "scene/Scene.h"

namespace aolib {

/// The scene's triangles in GPU memory, mesh by mesh.
class SceneGeometry {
public:
    /// Uploads what is new or changed, drops what is gone. Errors: OutOfMemory.
    Status update(const gl::Functions& gl, const Scene& scene,
                  const std::vector<Scene::Change>& changes);
    const gl::VertexArray& mesh(MeshId id) const { return meshes_.at(id); }
    std::size_t bytes() const;

private:
    std::map<MeshId, gl::VertexArray> meshes_;
};

} // namespace aolib
