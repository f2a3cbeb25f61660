// Models and case files: whatever the bytes are, there is a scene that holds together or a
// sentence.
#include <cmath>
#include <string_view>

#include "FuzzTarget.h"
#include "content/Case.h"
#include "content/ModelFile.h"

namespace {

void checkModel(const aolib::Model& model) {
    for (const aolib::ModelMesh& mesh : model.meshes) {
        for (const std::uint32_t index : mesh.indices) {
            aolib::fuzz::require(index < mesh.positions.size(), "an index names a vertex");
        }
        for (const glm::vec3& p : mesh.positions) {
            aolib::fuzz::require(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z),
                                 "positions are finite");
        }
        aolib::fuzz::require(mesh.indices.size() % 3 == 0, "triangles are whole");
    }
}

} // namespace

/// The first byte says which kind of file the others are.
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) {
        return 0;
    }
    const std::string_view text(reinterpret_cast<const char*>(data + 1), size - 1);
    if (data[0] == 'c') {
        const auto parsed = aolib::parseCase(text, "case.json");
        aolib::fuzz::require(parsed.ok() || !parsed.error().sentence.empty(), "a reason is given");
        if (parsed) {
            const auto again = aolib::parseCase(aolib::writeCase(*parsed), "case.json");
            aolib::fuzz::require(again.ok(), "what was written can be read");
        }
        return 0;
    }
    const char* file = data[0] == 'o' ? "m.obj" : data[0] == 'g' ? "m.gltf" : "m.glb";
    const auto model = aolib::readModel(text, file);
    aolib::fuzz::require(model.ok() || !model.error().sentence.empty(), "a reason is given");
    if (model) {
        checkModel(*model);
    }
    return 0;
}
