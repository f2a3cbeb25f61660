#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <tiny_gltf.h>

#include "content/LoadError.h"

namespace aolib {

/// A glTF as it is: the text of its JSON, and the bytes of its buffers.
struct GltfParts {
    std::string name; ///< the file, for messages
    std::string json; ///< valid, an object
    std::vector<std::string> buffers;
};

/// Takes a .gltf or .glb apart. `file` as for parseGltf().
Result<GltfParts, LoadError> openGltf(std::string_view bytes, const std::filesystem::path& file);

/// How much of a glTF is parsed.
enum class GltfMotion {
    LeftOut, ///< a damaged animation keeps nobody from the model at rest
    Parsed,  ///< animations and skins, too
};

/// A parsed glTF: its structure as tinygltf gives it, and the bytes of its buffers. Images,
/// textures and cameras are left out; buffer views are not yet checked.
struct GltfDocument {
    std::string name; ///< the file, for messages
    tinygltf::Model structure;
    std::vector<std::string> buffers;
};

/// Parses a .gltf or .glb. `file` gives the name in messages and the folder of external buffers.
Result<GltfDocument, LoadError> parseGltf(std::string_view bytes, const std::filesystem::path& file,
                                          GltfMotion motion = GltfMotion::LeftOut);

} // namespace aolib
