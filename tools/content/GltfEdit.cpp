#include "content/GltfEdit.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <map>
#include <utility>

#include <nlohmann/json.hpp>

#include "content/FileBytes.h"

namespace aolib {

namespace {

using Json = nlohmann::ordered_json;

constexpr int floatType = 5126;
constexpr int indexType = 5125;
constexpr int arrayBuffer = 34962;
constexpr int indexBuffer = 34963;
constexpr int linear = 9729;
constexpr int linearMipmapLinear = 9987;
constexpr int clampToEdge = 33071;
constexpr int triangles = 4;

std::size_t aligned(std::size_t size) {
    return (size + 3) / 4 * 4;
}

std::size_t componentBytes(int type) {
    switch (type) {
    case 5120:
    case 5121:
        return 1;
    case 5122:
    case 5123:
        return 2;
    default:
        return 4;
    }
}

std::size_t componentCount(const std::string& type) {
    static const std::map<std::string, std::size_t> counts{{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3},
                                                           {"VEC4", 4},   {"MAT2", 4}, {"MAT3", 9},
                                                           {"MAT4", 16}};
    return counts.at(type);
}

std::string mimeType(const std::filesystem::path& file, const std::string& bytes) {
    if (bytes.compare(0, 4, "\x89PNG") == 0) {
        return "image/png";
    }
    if (bytes.compare(0, 2, "\xff\xd8") == 0) {
        return "image/jpeg";
    }
    const std::string extension = file.extension().string();
    return "image/" + (extension.empty() ? "unknown" : extension.substr(1));
}

/// "%20" and the like as the characters they stand for.
std::string decoded(const std::string& uri) {
    std::string text;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        if (uri[i] == '%' && i + 2 < uri.size() && std::isxdigit(uri[i + 1]) != 0 &&
            std::isxdigit(uri[i + 2]) != 0) {
            text += static_cast<char>(std::stoi(uri.substr(i + 1, 2), nullptr, 16));
            i += 2;
        } else {
            text += uri[i];
        }
    }
    return text;
}

void appendU32(std::string& out, std::size_t value) {
    for (unsigned shift = 0; shift < 32; shift += 8) {
        out += static_cast<char>((value >> shift) & 0xffU);
    }
}

} // namespace

struct GltfEdit::Content {
    std::string name;
    Json json;
    std::string binary;

    Json& primitive(int mesh, int number) {
        return json.at("meshes").at(index(mesh)).at("primitives").at(index(number));
    }
    Json& material(int number) { return json.at("materials").at(index(number)); }
    static std::size_t index(int number) { return static_cast<std::size_t>(number); }

    int add(const char* array, Json element) {
        Json& elements = json[array];
        elements.push_back(std::move(element));
        return static_cast<int>(elements.size()) - 1;
    }

    int addView(std::string_view bytes, int target, std::size_t stride = 0) {
        binary.resize(aligned(binary.size()), '\0');
        Json view{{"buffer", 0}, {"byteOffset", binary.size()}, {"byteLength", bytes.size()}};
        if (stride != 0) {
            view["byteStride"] = stride;
        }
        if (target != 0) {
            view["target"] = target;
        }
        binary += bytes;
        return add("bufferViews", std::move(view));
    }

    std::optional<LoadError> packImages(const std::filesystem::path& folder);
    void joinBuffers(const std::vector<std::string>& buffers);
    Loaded<int> gathered(int accessor, const std::vector<std::uint32_t>& source);
    std::optional<LoadError> gatherAll(Json& attributes, const std::vector<std::uint32_t>& source);
};

void GltfEdit::Content::joinBuffers(const std::vector<std::string>& buffers) {
    std::vector<std::size_t> starts;
    for (const std::string& buffer : buffers) {
        binary.resize(aligned(binary.size()), '\0');
        starts.push_back(binary.size());
        binary += buffer;
    }
    if (json.contains("bufferViews")) {
        for (Json& view : json["bufferViews"]) {
            const auto buffer = view.at("buffer").get<std::size_t>();
            view["byteOffset"] = view.value("byteOffset", std::size_t{0}) + starts.at(buffer);
            view["buffer"] = 0;
        }
    }
}

std::optional<LoadError> GltfEdit::Content::packImages(const std::filesystem::path& folder) {
    if (!json.contains("images")) {
        return std::nullopt;
    }
    for (Json& image : json["images"]) {
        const std::string uri = image.value("uri", "");
        if (uri.empty() || uri.rfind("data:", 0) == 0) {
            continue;
        }
        const std::filesystem::path file = folder / decoded(uri);
        const Loaded<std::string> bytes = readFileBytes(file);
        if (!bytes) {
            return LoadError{name + " needs " + bytes.sentence()};
        }
        image.erase("uri");
        image["mimeType"] = mimeType(file, *bytes);
        image["bufferView"] = addView(*bytes, 0);
    }
    return std::nullopt;
}

/// An accessor whose element i is a copy of another one's `source[i]`.
Loaded<int> GltfEdit::Content::gathered(int accessor, const std::vector<std::uint32_t>& source) {
    Json made = json.at("accessors").at(index(accessor));
    if (made.contains("sparse") || !made.contains("bufferView")) {
        return LoadError{name + ": accessor " + std::to_string(accessor) +
                         " is sparse: its vertices cannot be split"};
    }
    const Json& view = json.at("bufferViews").at(made["bufferView"].get<std::size_t>());
    const std::string type = made.at("type").get<std::string>();
    const int component = made.at("componentType").get<int>();
    const std::size_t size = componentCount(type) * componentBytes(component);
    const std::size_t stride = view.value("byteStride", size);
    const std::size_t start =
        view.value("byteOffset", std::size_t{0}) + made.value("byteOffset", std::size_t{0});
    const std::size_t newStride = aligned(size);
    std::string bytes(newStride * source.size(), '\0');
    for (std::size_t i = 0; i < source.size(); ++i) {
        const std::size_t from = start + source[i] * stride;
        if (from + size > binary.size()) {
            return LoadError{name + ": accessor " + std::to_string(accessor) +
                             " reaches past the end of its buffer"};
        }
        std::memcpy(&bytes[i * newStride], &binary[from], size);
    }
    made.erase("byteOffset");
    made["count"] = source.size();
    if (made.contains("min") && component == floatType) {
        const std::size_t count = componentCount(type);
        std::vector<float> low(count, std::numeric_limits<float>::infinity());
        std::vector<float> high(count, -std::numeric_limits<float>::infinity());
        for (std::size_t i = 0; i < source.size() * count; ++i) {
            float value = 0.0F;
            std::memcpy(&value, &bytes[i * sizeof(float)], sizeof(float));
            low[i % count] = std::min(low[i % count], value);
            high[i % count] = std::max(high[i % count], value);
        }
        made["min"] = low;
        made["max"] = high;
    } else {
        made.erase("min");
        made.erase("max");
    }
    made["bufferView"] = addView(bytes, arrayBuffer, newStride);
    return add("accessors", std::move(made));
}

std::optional<LoadError> GltfEdit::Content::gatherAll(Json& attributes,
                                                      const std::vector<std::uint32_t>& source) {
    for (auto& [key, value] : attributes.items()) {
        const Loaded<int> made = gathered(value.get<int>(), source);
        if (!made) {
            return made.error();
        }
        value = *made;
    }
    return std::nullopt;
}

GltfEdit::GltfEdit(std::unique_ptr<Content> content) : content_(std::move(content)) {}
GltfEdit::GltfEdit(GltfEdit&&) noexcept = default;
GltfEdit& GltfEdit::operator=(GltfEdit&&) noexcept = default;
GltfEdit::~GltfEdit() = default;

Loaded<GltfEdit> GltfEdit::open(const GltfParts& parts, const std::filesystem::path& folder) {
    auto content = std::make_unique<Content>();
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
    const int mesh = nodes.at(Content::index(node)).at("mesh").get<int>();
    const auto sharers = std::count_if(nodes.begin(), nodes.end(), [&](const Json& other) {
        return other.value("mesh", -1) == mesh;
    });
    if (sharers < 2) {
        return mesh;
    }
    Json copy = content_->json.at("meshes").at(Content::index(mesh));
    const int made = content_->add("meshes", std::move(copy));
    nodes.at(Content::index(node))["mesh"] = made;
    return made;
}

std::optional<LoadError> GltfEdit::splitVertices(int mesh, int primitive,
                                                 const std::vector<std::uint32_t>& source,
                                                 const std::vector<std::uint32_t>& indices) {
    Json changed = content_->primitive(mesh, primitive);
    if (std::optional<LoadError> error = content_->gatherAll(changed.at("attributes"), source)) {
        return error;
    }
    if (changed.contains("targets")) {
        for (Json& target : changed["targets"]) {
            if (std::optional<LoadError> error = content_->gatherAll(target, source)) {
                return error;
            }
        }
    }
    std::string bytes;
    for (const std::uint32_t index : indices) {
        appendU32(bytes, index);
    }
    changed["indices"] =
        content_->add("accessors", Json{{"bufferView", content_->addView(bytes, indexBuffer)},
                                        {"componentType", indexType},
                                        {"count", indices.size()},
                                        {"type", "SCALAR"}});
    changed["mode"] = triangles;
    content_->primitive(mesh, primitive) = std::move(changed);
    return std::nullopt;
}

int GltfEdit::addFloats(const std::vector<float>& values, int components) {
    static const char* const types[] = {"", "SCALAR", "VEC2", "VEC3", "VEC4"};
    std::string bytes(values.size() * sizeof(float), '\0');
    std::memcpy(bytes.data(), values.data(), bytes.size());
    return content_->add("accessors", Json{{"bufferView", content_->addView(bytes, arrayBuffer)},
                                           {"componentType", floatType},
                                           {"count", values.size() / Content::index(components)},
                                           {"type", types[components]}});
}

Loaded<std::string> GltfEdit::glb() const {
    Json json = content_->json;
    const std::string& binary = content_->binary;
    if (binary.empty()) {
        json.erase("buffers");
    } else {
        json["buffers"] = Json::array({Json{{"byteLength", binary.size()}}});
    }
    std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
    text.resize(aligned(text.size()), ' ');
    const std::size_t binarySize = aligned(binary.size());
    const std::size_t total =
        12 + 8 + text.size() + (binary.empty() ? std::size_t{0} : 8 + binarySize);
    if (total > std::numeric_limits<std::uint32_t>::max()) {
        return LoadError{content_->name + ": with its maps larger than a GLB can be, 4 GiB"};
    }
    std::string out = "glTF";
    out.reserve(total);
    appendU32(out, 2);
    appendU32(out, total);
    appendU32(out, text.size());
    out += "JSON" + text;
    if (!binary.empty()) {
        appendU32(out, binarySize);
        out += std::string("BIN\0", 4) + binary;
        out.resize(total, '\0');
    }
    return out;
}

} // namespace aolib
