#include "backbone/texels/SceneGeometry.h"

#include <string>

#include <glm/matrix.hpp>

namespace aolib {

namespace {

Result<std::shared_ptr<const SceneGeometry::Piece>> upload(const gl::Functions& gl, MeshId id,
                                                           const Mesh& mesh, bool findThem) {
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
    return std::shared_ptr<const SceneGeometry::Piece>(
        std::make_shared<SceneGeometry::Piece>(std::move(piece)));
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
    for (const auto& [id, mesh] : scene.meshes()) {
        const auto found = pieces_.find(id);
        if (found == pieces_.end() || (solids && !found->second->solids)) {
            auto piece = upload(gl, id, mesh, solids);
            if (!piece) {
                return piece.status();
            }
            pieces_.insert_or_assign(id, std::move(*piece));
        }
    }
    return {};
}

std::shared_ptr<const SceneGeometry::Instances> SceneGeometry::instances(const Scene& scene) const {
    auto all = std::make_shared<Instances>();
    std::uint32_t solids = 0;
    for (const auto& [id, mesh] : scene.meshes()) {
        const std::shared_ptr<const Piece>& piece = pieces_.at(id);
        all->push_back({piece, mesh.transform, mesh.worldBounds(), solids});
        solids += piece->solids ? piece->solids->count() : 0;
    }
    return all;
}

std::size_t SceneGeometry::bytes() const {
    std::size_t sum = 0;
    for (const auto& [id, piece] : pieces_) {
        sum += piece->triangles.bytes();
    }
    return sum;
}

std::vector<float> SceneGeometry::enclosingSolids(const Scene& scene,
                                                  const glm::vec3& point) const {
    std::vector<float> around;
    std::uint32_t firstSolid = 0;
    for (const auto& [id, mesh] : scene.meshes()) {
        const std::optional<Solids>& solids = pieces_.at(id)->solids;
        if (!solids) {
            continue;
        }
        if (mesh.worldBounds().contains(point)) {
            const glm::vec3 local(glm::inverse(glm::dmat4(mesh.transform)) *
                                  glm::dvec4(point, 1.0));
            for (const std::uint32_t solid : aolib::enclosingSolids(mesh, *solids, local)) {
                around.push_back(static_cast<float>(firstSolid + solid + 1));
            }
        }
        firstSolid += solids->count();
    }
    return around;
}

} // namespace aolib
