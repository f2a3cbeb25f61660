#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "content/GltfDocument.h"
#include "content/LoadError.h"

namespace aolib {

struct GltfContent;

/// A glTF that is changed in places and otherwise kept as it is, extensions that nobody here knows
/// included, and written as one GLB. Numbers name elements of the JSON's arrays and must be those
/// of a glTF that readGltf() could read.
///
/// JSON that is not what glTF says ends in an nlohmann::json exception from any of the methods.
class GltfEdit {
public:
    /// Joins all buffers; images in files of their own are read from `folder` and packed in.
    static Result<GltfEdit, LoadError> open(const GltfParts& parts,
                                            const std::filesystem::path& folder);

    GltfEdit(GltfEdit&&) noexcept;
    GltfEdit& operator=(GltfEdit&&) noexcept;
    ~GltfEdit();

    std::string materialName(int material) const;
    int addMaterial(const std::string& name);
    void setMaterial(int mesh, int primitive, int material);
    /// The UV set of a material's occlusion texture, or -1.
    int occlusionUvSet(int material) const;
    /// Makes a PNG a material's occlusion texture, read with linear filters and mipmaps.
    void setOcclusionTexture(int material, std::span<const std::uint8_t> png, int uvSet,
                             const std::string& name);

    /// How many UV sets a primitive has, from TEXCOORD_0 on.
    int uvSets(int mesh, int primitive) const;
    /// The accessor of an attribute, or -1.
    int attribute(int mesh, int primitive, const std::string& name) const;
    void setAttribute(int mesh, int primitive, const std::string& name, int accessor);
    /// The mesh of a node, which from now on no other node has.
    int ownMesh(int node);
    /// Replaces a primitive's vertices: new vertex i is a copy of the old `source[i]`, in all
    /// attributes and morph targets, and triangles of the new ones take the place of its indices.
    /// Fails on sparse attributes.
    std::optional<LoadError> splitVertices(int mesh, int primitive,
                                           const std::vector<std::uint32_t>& source,
                                           const std::vector<std::uint32_t>& indices);
    /// Numbers among a primitive's `extras`, beside those that are there.
    void setExtra(int mesh, int primitive, const std::string& name,
                  const std::vector<float>& numbers);
    /// An accessor of floats, 1 to 4 per element.
    int addFloats(const std::vector<float>& values, int components);

    /// The whole as a GLB. Fails beyond 4 GiB.
    Result<std::string, LoadError> glb() const;

private:
    explicit GltfEdit(std::unique_ptr<GltfContent> content);

    std::unique_ptr<GltfContent> content_;
};

} // namespace aolib
