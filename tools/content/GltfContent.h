#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "content/LoadError.h"

namespace aolib {

// What glTF calls these, as OpenGL does.
constexpr int kGltfFloat = 5126;
constexpr int kGltfUnsignedInt = 5125;
constexpr int kGltfArrayBuffer = 34962;
constexpr int kGltfElementArrayBuffer = 34963;

/// The next multiple of four: where a glTF's parts begin.
constexpr std::size_t alignedToFour(std::size_t size) {
    return (size + 3) / 4 * 4;
}

/// Appends a number's lowest 32 bits, lowest byte first.
void appendU32(std::string& out, std::size_t value);

/// A glTF taken apart for changes: its JSON, and all its buffers as one. Where the JSON is not what
/// glTF says, methods throw nlohmann::json's exceptions.
struct GltfContent {
    using Json = nlohmann::ordered_json;

    std::string name;
    Json json;
    std::string binary;

    Json& primitive(int mesh, int number) {
        return json.at("meshes").at(index(mesh)).at("primitives").at(index(number));
    }
    Json& material(int number) { return json.at("materials").at(index(number)); }
    static std::size_t index(int number) { return static_cast<std::size_t>(number); }

    /// Appends an element to one of the JSON's arrays. Gives its number.
    int add(const char* array, Json element);
    /// Appends bytes to the binary. Gives the number of their view.
    /// @param target  of the view, @param stride  of its elements, bytes; 0 for none.
    int addView(std::string_view bytes, int target, std::size_t stride = 0);

    /// Makes one binary of all buffers.
    void joinBuffers(const std::vector<std::string>& buffers);
    /// Reads images in files of their own and packs them in.
    std::optional<LoadError> packImages(const std::filesystem::path& folder);
    /// The whole as a GLB. Fails beyond 4 GiB.
    Result<std::string, LoadError> glb() const;
};

} // namespace aolib
