// Sequences of scene definition calls in any order, with any numbers: a mesh comes out whole or not
// at all, and the scene takes what comes out.
#include "FuzzTarget.h"
#include "scene/Scene.h"
#include "scene/SceneBuilder.h"
#include "scene/Solids.h"

namespace {

using aolib::fuzz::Bytes;
using aolib::fuzz::require;

glm::vec3 vector(Bytes& bytes) {
    const bool whole = (bytes.take<std::uint8_t>() & 3) != 0; // mostly: others are mostly refused
    if (!whole) {
        return {bytes.take<float>(), bytes.take<float>(), bytes.take<float>()};
    }
    const auto coordinate = [&] { return static_cast<float>(bytes.take<std::int8_t>()) * 0.25F; };
    return {coordinate(), coordinate(), coordinate()};
}

void keep(aolib::Scene& scene, aolib::Result<aolib::Mesh> mesh, std::vector<aolib::MeshId>& ids) {
    if (!mesh) {
        require(!mesh.status().message().empty(), "a reason is given");
        return;
    }
    require(!mesh->indices.empty() && mesh->indices.size() % 3 == 0, "triangles are whole");
    for (const std::uint32_t index : mesh->indices) {
        require(index < mesh->positions.size(), "an index names a vertex");
    }
    const aolib::Solids solids = aolib::findSolids(*mesh);
    (void)enclosingSolids(*mesh, solids, {0.3F, 0.2F, 0.1F});
    ids.push_back(scene.add(std::move(*mesh)));
}

void edit(aolib::Scene& scene, const std::vector<aolib::MeshId>& ids, Bytes& bytes) {
    if (ids.empty()) {
        return;
    }
    const aolib::MeshId id = ids[bytes.take<std::uint8_t>() % ids.size()];
    glm::mat4 transform(1.0F);
    transform[3] = glm::vec4(vector(bytes), 1.0F);
    transform[0][0] = bytes.take<float>();
    if (bytes.take<std::uint8_t>() % 4 == 0) {
        (void)scene.remove(id);
    } else {
        (void)scene.move(id, transform);
    }
    (void)scene.clearance(vector(bytes));
    (void)scene.takeChanges();
}

} // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    Bytes bytes(data, size);
    aolib::SceneBuilder builder;
    aolib::Scene scene;
    std::vector<aolib::MeshId> ids;
    while (!bytes.empty()) {
        switch (bytes.take<std::uint8_t>() % 9) {
        case 0:
            (void)builder.begin();
            break;
        case 1:
            (void)builder.normal(vector(bytes));
            break;
        case 2:
        case 3:
            (void)builder.vertex(vector(bytes));
            break;
        case 4:
            (void)builder.beginRun(static_cast<aolib::AoPrimitive>(bytes.take<std::uint8_t>() % 7));
            break;
        case 5:
            (void)builder.index(bytes.take<std::uint8_t>() % 3 == 0
                                    ? bytes.take<std::uint32_t>()
                                    : bytes.take<std::uint8_t>() % 8);
            break;
        case 6:
            (void)builder.endRun();
            break;
        case 7:
            keep(scene, builder.end(), ids);
            break;
        default:
            edit(scene, ids, bytes);
            break;
        }
    }
    require(scene.bounds().empty() == scene.meshes().empty(), "a scene with meshes has bounds");
    return 0;
}
