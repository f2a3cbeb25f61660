#include "content/GltfEdit.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "content/GltfContent.h"
#include "content/GltfGather.h"

namespace aolib {

namespace {

using Json = GltfContent::Json;

constexpr int linear = 9729;
constexpr int linearMipmapLinear = 9987;
constexpr int clampToEdge = 33071;
constexpr int triangles = 4;

} // namespace

GltfEdit::GltfEdit(std::unique_ptr<GltfContent> content) : content_(std::move(content)) {}
GltfEdit::GltfEdit(GltfEdit&&) noexcept = default;
GltfEdit& GltfEdit::operator=(GltfEdit&&) noexcept = default;
GltfEdit::~GltfEdit() = default;

Result<GltfEdit, LoadError> GltfEdit::open(const GltfParts& parts,
                                           const std::filesystem::path& folder) {
    auto content = std::make_unique<GltfContent>();
    content->name = parts.name;
    content->json = Json::parse(parts.json);
    content->joinBuffers(parts.buffers);
    if (std::optional<LoadError> error = content->packImages(folder)) {
        return *error;
    }
    return GltfEdit(std::move(content));
}

std::string GltfEdit::materialName(int material) const {
    return content_->material(material).value("name", "material " + std::to_string(material));
}

int GltfEdit::addMaterial(const std::string& name) {
    return content_->add("materials", Json{{"name", name}});
}

void GltfEdit::setMaterial(int mesh, int primitive, int material) {
    content_->primitive(mesh, primitive)["material"] = material;
}

int GltfEdit::occlusionUvSet(int material) const {
    const Json& found = content_->material(material);
    return found.contains("occlusionTexture") ? found["occlusionTexture"].value("texCoord", 0) : -1;
}

void GltfEdit::setOcclusionTexture(int material, std::span<const std::uint8_t> png, int uvSet,
                                   const std::string& name) {
    const std::string_view bytes(reinterpret_cast<const char*>(png.data()), png.size());
    const int view = content_->addView(bytes, 0);
    const int image = content_->add(
        "images", Json{{"name", name}, {"mimeType", "image/png"}, {"bufferView", view}});
    const int sampler = content_->add("samplers", Json{{"magFilter", linear},
                                                       {"minFilter", linearMipmapLinear},
                                                       {"wrapS", clampToEdge},
                                                       {"wrapT", clampToEdge}});
    const int texture =
        content_->add("textures", Json{{"name", name}, {"sampler", sampler}, {"source", image}});
    Json occlusion{{"index", texture}};
    if (uvSet != 0) {
        occlusion["texCoord"] = uvSet;
    }
    content_->material(material)["occlusionTexture"] = std::move(occlusion);
}

int GltfEdit::uvSets(int mesh, int primitive) const {
    int count = 0;
    while (attribute(mesh, primitive, "TEXCOORD_" + std::to_string(count)) >= 0) {
        ++count;
    }
    return count;
}

int GltfEdit::attribute(int mesh, int primitive, const std::string& name) const {
    return content_->primitive(mesh, primitive).at("attributes").value(name, -1);
}

void GltfEdit::setAttribute(int mesh, int primitive, const std::string& name, int accessor) {
    content_->primitive(mesh, primitive)["attributes"][name] = accessor;
}

int GltfEdit::ownMesh(int node) {
    Json& nodes = content_->json.at("nodes");
    const int mesh = nodes.at(GltfContent::index(node)).at("mesh").get<int>();
    const auto sharers = std::count_if(nodes.begin(), nodes.end(), [&](const Json& other) {
        return other.value("mesh", -1) == mesh;
    });
    if (sharers < 2) {
        return mesh;
    }
    Json copy = content_->json.at("meshes").at(GltfContent::index(mesh));
    const int made = content_->add("meshes", std::move(copy));
    nodes.at(GltfContent::index(node))["mesh"] = made;
    return made;
}

std::optional<LoadError> GltfEdit::splitVertices(int mesh, int primitive,
                                                 const std::vector<std::uint32_t>& source,
                                                 const std::vector<std::uint32_t>& indices) {
    Json changed = content_->primitive(mesh, primitive);
    if (std::optional<LoadError> error =
            gatherVertices(*content_, changed.at("attributes"), source)) {
        return error;
    }
    if (changed.contains("targets")) {
        for (Json& target : changed["targets"]) {
            if (std::optional<LoadError> error = gatherVertices(*content_, target, source)) {
                return error;
            }
        }
    }
    std::string bytes;
    for (const std::uint32_t index : indices) {
        appendU32(bytes, index);
    }
    changed["indices"] = content_->add(
        "accessors", Json{{"bufferView", content_->addView(bytes, kGltfElementArrayBuffer)},
                          {"componentType", kGltfUnsignedInt},
                          {"count", indices.size()},
                          {"type", "SCALAR"}});
    changed["mode"] = triangles;
    content_->primitive(mesh, primitive) = std::move(changed);
    return std::nullopt;
}

void GltfEdit::setExtra(int mesh, int primitive, const std::string& name,
                        const std::vector<float>& numbers) {
    GltfContent::Json& extras = content_->primitive(mesh, primitive)["extras"];
    if (!extras.is_object()) {
        extras = GltfContent::Json::object();
    }
    extras[name] = numbers;
}

int GltfEdit::addFloats(const std::vector<float>& values, int components) {
    static const char* const types[] = {"", "SCALAR", "VEC2", "VEC3", "VEC4"};
    std::string bytes(values.size() * sizeof(float), '\0');
    std::memcpy(bytes.data(), values.data(), bytes.size());
    return content_->add("accessors",
                         Json{{"bufferView", content_->addView(bytes, kGltfArrayBuffer)},
                              {"componentType", kGltfFloat},
                              {"count", values.size() / GltfContent::index(components)},
                              {"type", types[components]}});
}

Result<std::string, LoadError> GltfEdit::glb() const {
    return content_->glb();
}

} // namespace aolib
