#include "content/GltfContent.h"

#include <cctype>
#include <limits>
#include <utility>

#include "content/FileBytes.h"

namespace aolib {

namespace {

using Json = GltfContent::Json;

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

} // namespace

void appendU32(std::string& out, std::size_t value) {
    for (unsigned shift = 0; shift < 32; shift += 8) {
        out += static_cast<char>((value >> shift) & 0xffU);
    }
}

int GltfContent::add(const char* array, Json element) {
    Json& elements = json[array];
    elements.push_back(std::move(element));
    return static_cast<int>(elements.size()) - 1;
}

int GltfContent::addView(std::string_view bytes, int target, std::size_t stride) {
    binary.resize(alignedToFour(binary.size()), '\0');
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

void GltfContent::joinBuffers(const std::vector<std::string>& buffers) {
    std::vector<std::size_t> starts;
    for (const std::string& buffer : buffers) {
        binary.resize(alignedToFour(binary.size()), '\0');
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

std::optional<LoadError> GltfContent::packImages(const std::filesystem::path& folder) {
    if (!json.contains("images")) {
        return std::nullopt;
    }
    for (Json& image : json["images"]) {
        const std::string uri = image.value("uri", "");
        if (uri.empty() || uri.rfind("data:", 0) == 0) {
            continue;
        }
        const std::filesystem::path file = folder / decoded(uri);
        const Result<std::string, LoadError> bytes = readFileBytes(file);
        if (!bytes) {
            return LoadError{name + " needs " + bytes.error().sentence};
        }
        image.erase("uri");
        image["mimeType"] = mimeType(file, *bytes);
        image["bufferView"] = addView(*bytes, 0);
    }
    return std::nullopt;
}

Result<std::string, LoadError> GltfContent::glb() const {
    Json whole = json;
    if (binary.empty()) {
        whole.erase("buffers");
    } else {
        whole["buffers"] = Json::array({Json{{"byteLength", binary.size()}}});
    }
    std::string text = whole.dump(-1, ' ', false, Json::error_handler_t::replace);
    text.resize(alignedToFour(text.size()), ' ');
    const std::size_t binarySize = alignedToFour(binary.size());
    const std::size_t total =
        12 + 8 + text.size() + (binary.empty() ? std::size_t{0} : 8 + binarySize);
    if (total > std::numeric_limits<std::uint32_t>::max()) {
        return LoadError{name + ": with its maps larger than a GLB can be, 4 GiB"};
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
