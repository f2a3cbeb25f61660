#include "backbone/SceneGeometry.h"

#include <string>

#include <glm/matrix.hpp>

namespace aolib {

namespace {

Result<SceneGeometry::Piece> upload(const gl::Functions& gl, MeshId id, const Mesh& mesh,
                                    bool findThem) {
    SceneGeometry::Piece piece;
    std::vector<float> solidOfVertex;
    if (findThem) {
        piece.solids = findSolids(mesh);
        if (piece.solids->count() > 0) {
            solidOfVertex.assign(piece.solids->solidOfVertex.begin(),
                                 piece.solids->solidOfVertex.end());
        }
    }
    auto triangles = gl::VertexArray::createTriangles(
        gl,
        {mesh.positions, mesh.normals, solidOfVertex,
         piece.solids ? piece.solids->indices : mesh.indices},
        "aolib/mesh" + std::to_string(static_cast<std::uint32_t>(id)));
    if (!triangles) {
        return triangles.status();
    }
    piece.triangles = std::move(*triangles);
    return piece;
}

} // namespace

void SceneGeometry::forget(const std::vector<Scene::Change>& changes) {
    for (const Scene::Change& change : changes) {
        if (change.geometry) {
            pieces_.erase(change.id);
        }
    }
}

AoStatus SceneGeometry::update(const gl::Functions& gl, const Scene& scene,
                               const std::vector<Scene::Change>& changes, bool solids) {
    forget(changes);
    std::uint32_t firstSolid = 0;
    for (const auto& [id, mesh] : scene.meshes()) {
        auto found = pieces_.find(id);
        if (found == pieces_.end() || (solids && !found->second.solids)) {
            auto piece = upload(gl, id, mesh, solids);
            if (!piece) {
                return piece.status();
            }
            found = pieces_.insert_or_assign(id, std::move(*piece)).first;
        }
        found->second.firstSolid = firstSolid;
        firstSolid += found->second.solids ? found->second.solids->count() : 0;
    }
    return {};
}

std::size_t SceneGeometry::bytes() const {
    std::size_t sum = 0;
    for (const auto& [id, piece] : pieces_) {
        sum += piece.triangles.bytes();
    }
    return sum;
}

std::vector<float> SceneGeometry::solidsAround(const Scene& scene, const glm::vec3& point) const {
    std::vector<float> around;
    for (const auto& [id, mesh] : scene.meshes()) {
        const Piece& found = piece(id);
        if (!found.solids || !mesh.worldBounds().contains(point)) {
            continue;
        }
        const glm::vec3 local(glm::inverse(glm::dmat4(mesh.transform)) * glm::dvec4(point, 1.0));
        for (const std::uint32_t solid : aolib::solidsAround(mesh, *found.solids, local)) {
            around.push_back(static_cast<float>(found.firstSolid + solid + 1));
        }
    }
    return around;
}

} // namespace aolib
