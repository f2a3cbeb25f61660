#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <tiny_gltf.h>

#include "content/Loaded.h"

namespace aolib {

/// A parsed glTF: its structure as tinygltf gives it, and the bytes of its buffers. Images,
/// textures, animations, skins and cameras are left out; buffer views are not yet checked.
struct GltfDocument {
    std::string name; ///< the file, for messages
    tinygltf::Model structure;
    std::vector<std::string> buffers;
};

/// Parses a .gltf or .glb. `file` gives the name in messages and the folder of external buffers.
Loaded<GltfDocument> parseGltf(std::string_view bytes, const std::filesystem::path& file);

} // namespace aolib
