#include "backbone/SceneGeometry.h"

#include <string>

namespace aolib {

Status SceneGeometry::update(const gl::Functions& gl, const Scene& scene,
                             const std::vector<Scene::Change>& changes) {
    for (const Scene::Change& change : changes) {
        if (change.geometry) {
            meshes_.erase(change.id);
        }
    }
    for (const auto& [id, mesh] : scene.meshes()) {
        if (meshes_.count(id) != 0) {
            continue;
        }
        auto uploaded = gl::VertexArray::createTriangles(
            gl, mesh.positions, mesh.normals, mesh.indices,
            "aolib/mesh" + std::to_string(static_cast<std::uint32_t>(id)));
        if (!uploaded) {
            return uploaded.status();
        }
        meshes_.emplace(id, std::move(*uploaded));
    }
    return {};
}

std::size_t SceneGeometry::bytes() const {
    std::size_t sum = 0;
    for (const auto& [id, mesh] : meshes_) {
        sum += mesh.bytes();
    }
    return sum;
}

} // namespace aolib
