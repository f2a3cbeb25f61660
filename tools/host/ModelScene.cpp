#include "host/ModelScene.h"

namespace aolib::host {

Result<std::vector<MeshId>> describeScene(AmbientOcclusion& ao, const Model& model,
                                          SceneNormals normals) {
    std::vector<MeshId> ids;
    for (const ModelMesh& mesh : model.meshes) {
        if (mesh.indices.empty()) {
            continue;
        }
        MeshData data;
        data.positions = mesh.positions;
        if (normals == SceneNormals::Model) {
            data.normals = mesh.normals;
        }
        data.indices = mesh.indices;
        data.transform = mesh.transform;
        const Result<MeshId> id = ao.addMesh(data);
        if (!id) {
            return AoStatus(id.status().code(), mesh.name + ": " + id.status().message());
        }
        ids.push_back(*id);
    }
    if (ids.empty()) {
        return AoStatus(StatusCode::NoScene, model.name + " holds no triangles");
    }
    return ids;
}

} // namespace aolib::host
