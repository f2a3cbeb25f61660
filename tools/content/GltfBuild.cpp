#include "content/GltfBuild.h"

#include <cstring>
#include <span>
#include <utility>

#include <nlohmann/json.hpp>

namespace aolib {

namespace {

using Json = nlohmann::ordered_json;

constexpr int floatType = 5126;
constexpr int indexType = 5125;
constexpr int arrayBuffer = 34962;
constexpr int indexBuffer = 34963;

class Builder {
public:
    explicit Builder(std::string name) : name_(std::move(name)) {
        json_["asset"] = {{"version", "2.0"}, {"generator", "aolib"}};
        json_["scene"] = 0;
        Json scene;
        scene["nodes"] = Json::array();
        json_["scenes"] = Json::array({std::move(scene)});
    }

    template <typename T>
    int accessor(std::span<const T> values, const char* type, int component, int target) {
        json_["bufferViews"].push_back({{"buffer", 0},
                                        {"byteOffset", bytes_.size()},
                                        {"byteLength", values.size_bytes()},
                                        {"target", target}});
        bytes_.append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
        json_["accessors"].push_back({{"bufferView", json_["bufferViews"].size() - 1},
                                      {"componentType", component},
                                      {"count", values.size()},
                                      {"type", type}});
        return static_cast<int>(json_["accessors"].size()) - 1;
    }

    void add(const ModelMesh& mesh, const std::vector<glm::vec2>& uvs) {
        Json attributes;
        attributes["POSITION"] =
            accessor<glm::vec3>(mesh.positions, "VEC3", floatType, arrayBuffer);
        Bounds bounds;
        for (const glm::vec3& p : mesh.positions) {
            bounds.include(p);
        }
        json_["accessors"].back()["min"] = {bounds.min.x, bounds.min.y, bounds.min.z};
        json_["accessors"].back()["max"] = {bounds.max.x, bounds.max.y, bounds.max.z};
        if (!mesh.normals.empty()) {
            attributes["NORMAL"] =
                accessor<glm::vec3>(mesh.normals, "VEC3", floatType, arrayBuffer);
        }
        if (!uvs.empty()) {
            std::vector<glm::vec2> downwards = uvs; // glTF counts v from the top
            for (glm::vec2& uv : downwards) {
                uv.y = 1.0F - uv.y;
            }
            attributes["TEXCOORD_0"] =
                accessor<glm::vec2>(downwards, "VEC2", floatType, arrayBuffer);
        }
        const int indices = accessor<std::uint32_t>(mesh.indices, "SCALAR", indexType, indexBuffer);
        const std::size_t number = json_.contains("nodes") ? json_["nodes"].size() : 0;
        Json material{{"name", mesh.name}, {"doubleSided", mesh.doubleSided}};
        material["pbrMetallicRoughness"] = {
            {"baseColorFactor",
             {mesh.baseColour.r, mesh.baseColour.g, mesh.baseColour.b, mesh.baseColour.a}},
            {"metallicFactor", 0.0}};
        json_["materials"].push_back(std::move(material));
        Json primitive;
        primitive["attributes"] = std::move(attributes);
        primitive["indices"] = indices;
        primitive["material"] = number;
        json_["meshes"].push_back(
            {{"name", mesh.name}, {"primitives", Json::array({std::move(primitive)})}});
        Json node{{"name", mesh.name}, {"mesh", number}};
        if (mesh.transform != glm::mat4(1.0F)) {
            const float* m = &mesh.transform[0][0];
            node["matrix"] = std::vector<float>(m, m + 16);
        }
        json_["nodes"].push_back(std::move(node));
        json_["scenes"][0]["nodes"].push_back(number);
    }

    GltfParts parts() {
        Json buffer;
        buffer["byteLength"] = bytes_.size();
        json_["buffers"] = Json::array({std::move(buffer)});
        return {name_, json_.dump(-1, ' ', false, Json::error_handler_t::replace), {bytes_}};
    }

private:
    std::string name_;
    Json json_;
    std::string bytes_;
};

} // namespace

GltfParts gltfOf(const Model& model) {
    Builder builder(model.name);
    for (const ModelMesh& mesh : model.meshes) {
        builder.add(mesh, {});
    }
    return builder.parts();
}

GltfParts gltfOf(const UvMesh& mesh, const std::string& name) {
    Builder builder(name);
    ModelMesh plain;
    plain.name = name;
    plain.positions = mesh.positions;
    plain.normals = mesh.normals;
    plain.indices = mesh.indices;
    builder.add(plain, mesh.uvs);
    return builder.parts();
}

} // namespace aolib
