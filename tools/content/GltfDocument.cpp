#include "content/GltfDocument.h"

#include <array>
#include <charconv>
#include <cstdint>
#include <optional>

#include <nlohmann/json.hpp>

#include "content/FileBytes.h"

namespace aolib {
namespace {

using PlainJson = nlohmann::json;

constexpr int deepestNesting = 64;
constexpr std::size_t headerSize = 12;
constexpr std::size_t chunkHeaderSize = 8;
constexpr std::uint32_t jsonChunk = 0x4E4F534A;
constexpr std::uint32_t binaryChunk = 0x004E4942;

/// What the reader uses. Everything else, images above all, never reaches tinygltf.
constexpr std::array<const char*, 8> keptMembers{"asset",  "scene",     "scenes",      "nodes",
                                                 "meshes", "accessors", "bufferViews", "materials"};

/// What is used beyond that where it is to move.
constexpr std::array<const char*, 2> movingMembers{"animations", "skins"};

/// Extensions that move the triangles to where this reader does not look.
constexpr std::array<const char*, 3> unreadableExtensions{
    "KHR_draco_mesh_compression", "EXT_meshopt_compression", "EXT_mesh_gpu_instancing"};

struct Container {
    std::string_view json;
    std::optional<std::string_view> binary;
};

std::uint32_t readU32(std::string_view bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + i])) << (8 * i);
    }
    return value;
}

/// The JSON and binary chunks of a GLB; the whole text for a .gltf.
Result<Container, LoadError> openContainer(std::string_view bytes, const std::string& name) {
    if (bytes.substr(0, 4) != "glTF") {
        return Container{bytes, std::nullopt};
    }
    if (bytes.size() < headerSize + chunkHeaderSize) {
        return LoadError{name + ": truncated, only " + std::to_string(bytes.size()) + " bytes"};
    }
    if (readU32(bytes, 4) != 2) {
        return LoadError{name + ": glTF container version " + std::to_string(readU32(bytes, 4)) +
                         ", only 2 is known"};
    }
    const std::size_t length = readU32(bytes, 8);
    if (length > bytes.size()) {
        return LoadError{name + ": truncated, the header promises " + std::to_string(length) +
                         " bytes and the file has " + std::to_string(bytes.size())};
    }
    bytes = bytes.substr(0, length);
    Container container;
    std::size_t at = headerSize;
    while (at + chunkHeaderSize <= bytes.size()) {
        const std::size_t size = readU32(bytes, at);
        const std::uint32_t kind = readU32(bytes, at + 4);
        at += chunkHeaderSize;
        if (size > bytes.size() - at) {
            return LoadError{name + ": a chunk of " + std::to_string(size) +
                             " bytes reaches past the end"};
        }
        if (kind == jsonChunk && container.json.empty()) {
            container.json = bytes.substr(at, size);
        } else if (kind == binaryChunk && !container.binary) {
            container.binary = bytes.substr(at, size);
        }
        at += size;
    }
    if (container.json.empty()) {
        return LoadError{name + ": a glTF container without a JSON chunk"};
    }
    return container;
}

Result<PlainJson, LoadError> parseJson(std::string_view text, const std::string& name) {
    bool tooDeep = false;
    const auto watchDepth = [&](int depth, PlainJson::parse_event_t, PlainJson&) {
        tooDeep = tooDeep || depth > deepestNesting;
        return !tooDeep;
    };
    try {
        PlainJson json = PlainJson::parse(text.begin(), text.end(), watchDepth);
        if (tooDeep) {
            return LoadError{name + ": its JSON nests deeper than " +
                             std::to_string(deepestNesting) + " levels"};
        }
        if (!json.is_object()) {
            return LoadError{name + ": its JSON is not an object"};
        }
        return json;
    } catch (const PlainJson::parse_error& error) {
        return LoadError{name + ": not valid JSON near byte " + std::to_string(error.byte)};
    } catch (const PlainJson::exception&) {
        return LoadError{name + ": its JSON holds a number out of range"};
    }
}

std::string percentDecoded(std::string_view uri) {
    std::string result;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        unsigned value = 0;
        if (uri[i] == '%' && i + 2 < uri.size() &&
            std::from_chars(uri.data() + i + 1, uri.data() + i + 3, value, 16).ptr ==
                uri.data() + i + 3) {
            result += static_cast<char>(value);
            i += 2;
        } else {
            result += uri[i];
        }
    }
    return result;
}

Result<std::string, LoadError> fetchUri(const std::string& uri, const std::filesystem::path& file) {
    if (tinygltf::IsDataURI(uri)) {
        std::vector<unsigned char> data;
        std::string mimeType;
        if (!tinygltf::DecodeDataURI(&data, mimeType, uri, 0, false)) {
            return LoadError{file.string() + ": a buffer's data URI cannot be decoded"};
        }
        return std::string(data.begin(), data.end());
    }
    if (uri.find("://") != std::string::npos || uri.rfind("data:", 0) == 0) {
        return LoadError{file.string() + ": a buffer's address is of a kind that is not read: " +
                         uri.substr(0, 60)};
    }
    Result<std::string, LoadError> bytes = readFileBytes(file.parent_path() / percentDecoded(uri));
    return bytes ? bytes : LoadError{file.string() + " needs " + bytes.error().sentence};
}

Result<std::string, LoadError> loadBuffer(const PlainJson& buffer, std::size_t index,
                                          const Container& container,
                                          const std::filesystem::path& file) {
    const std::string where = file.string() + ": buffer " + std::to_string(index);
    if (!buffer.is_object() || !buffer.contains("byteLength") ||
        !buffer["byteLength"].is_number_unsigned()) {
        return LoadError{where + " has no byteLength"};
    }
    const auto length = buffer["byteLength"].get<std::size_t>();
    Result<std::string, LoadError> bytes = std::string();
    if (buffer.contains("uri")) {
        if (!buffer["uri"].is_string()) {
            return LoadError{where + " has a uri that is not a string"};
        }
        bytes = fetchUri(buffer["uri"].get<std::string>(), file);
    } else if (index == 0 && container.binary) {
        bytes = std::string(*container.binary);
    } else {
        return LoadError{where + " has neither a uri nor a binary chunk"};
    }
    if (bytes && bytes->size() < length) {
        return LoadError{where + " should have " + std::to_string(length) + " bytes and has " +
                         std::to_string(bytes->size())};
    }
    if (bytes) {
        bytes->resize(length);
    }
    return bytes;
}

Result<std::vector<std::string>, LoadError>
loadBuffers(const PlainJson& json, const Container& container, const std::filesystem::path& file) {
    std::vector<std::string> buffers;
    if (json.contains("buffers") && json["buffers"].is_array()) {
        for (const PlainJson& description : json["buffers"]) {
            Result<std::string, LoadError> buffer =
                loadBuffer(description, buffers.size(), container, file);
            if (!buffer) {
                return buffer.error();
            }
            buffers.push_back(std::move(*buffer));
        }
    }
    return buffers;
}

std::optional<LoadError> refuseUnreadable(const PlainJson& json, const std::string& name) {
    if (!json.contains("extensionsRequired") || !json["extensionsRequired"].is_array()) {
        return std::nullopt;
    }
    for (const PlainJson& required : json["extensionsRequired"]) {
        for (const char* extension : unreadableExtensions) {
            if (required == extension) {
                return LoadError{name + ": needs the extension " + extension +
                                 ", which is not supported"};
            }
        }
    }
    return std::nullopt;
}

std::string firstLine(std::string text) {
    text.resize(std::min(text.find('\n'), text.size()));
    return text;
}

} // namespace

Result<GltfParts, LoadError> openGltf(std::string_view bytes, const std::filesystem::path& file) {
    const std::string name = file.string();
    const Result<Container, LoadError> container = openContainer(bytes, name);
    if (!container) {
        return container.error();
    }
    const Result<PlainJson, LoadError> json = parseJson(container->json, name);
    if (!json) {
        return json.error();
    }
    Result<std::vector<std::string>, LoadError> buffers = loadBuffers(*json, *container, file);
    if (!buffers) {
        return buffers.error();
    }
    return GltfParts{name, std::string(container->json), std::move(*buffers)};
}

Result<GltfDocument, LoadError> parseGltf(std::string_view bytes, const std::filesystem::path& file,
                                          GltfMotion motion) {
    GltfDocument document;
    document.name = file.string();
    const Result<Container, LoadError> container = openContainer(bytes, document.name);
    if (!container) {
        return container.error();
    }
    const Result<PlainJson, LoadError> json = parseJson(container->json, document.name);
    if (!json) {
        return json.error();
    }
    if (const std::optional<LoadError> error = refuseUnreadable(*json, document.name)) {
        return *error;
    }
    Result<std::vector<std::string>, LoadError> buffers = loadBuffers(*json, *container, file);
    if (!buffers) {
        return buffers.error();
    }
    document.buffers = std::move(*buffers);
    PlainJson kept = PlainJson::object();
    for (const char* member : keptMembers) {
        if (json->contains(member)) {
            kept[member] = (*json)[member];
        }
    }
    for (const char* member : movingMembers) {
        if (motion == GltfMotion::Parsed && json->contains(member)) {
            kept[member] = (*json)[member];
        }
    }
    const std::string text = kept.dump(-1, ' ', false, PlainJson::error_handler_t::replace);
    std::string reason;
    std::string warning;
    tinygltf::TinyGLTF parser;
    if (!parser.LoadASCIIFromString(&document.structure, &reason, &warning, text.c_str(),
                                    static_cast<unsigned>(text.size()), "",
                                    tinygltf::REQUIRE_VERSION)) {
        return LoadError{document.name + ": not a usable glTF (" + firstLine(reason) + ")"};
    }
    return document;
}

} // namespace aolib
