#include "content/GltfMesh.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include <glm/geometric.hpp>

#include "content/GltfAccessor.h"

namespace aolib {
namespace {

bool isTriangleMode(int mode) {
    return mode == TINYGLTF_MODE_TRIANGLES || mode == TINYGLTF_MODE_TRIANGLE_STRIP ||
           mode == TINYGLTF_MODE_TRIANGLE_FAN;
}

/// Triangles from the corner list of a primitive; a strip turns every other triangle round.
std::vector<std::uint32_t> toTriangles(int mode, std::vector<std::uint32_t> corners) {
    if (mode == TINYGLTF_MODE_TRIANGLES) {
        return corners;
    }
    std::vector<std::uint32_t> result;
    for (std::size_t i = 2; i < corners.size(); ++i) {
        if (mode == TINYGLTF_MODE_TRIANGLE_FAN) {
            result.insert(result.end(), {corners[0], corners[i - 1], corners[i]});
        } else if (i % 2 == 0) {
            result.insert(result.end(), {corners[i - 2], corners[i - 1], corners[i]});
        } else {
            result.insert(result.end(), {corners[i - 1], corners[i - 2], corners[i]});
        }
    }
    return result;
}

class GltfMeshReader {
public:
    explicit GltfMeshReader(const GltfDocument& document)
        : document_(document), gltf_(document.structure) {}

    Result<std::vector<ModelMesh>, LoadError> read(std::size_t index) const;

private:
    LoadError failure(const std::string& reason) const {
        return LoadError{document_.name + ": " + reason};
    }
    Result<ModelMesh, LoadError> loadPrimitive(const tinygltf::Primitive& primitive,
                                               const std::string& where) const;
    Result<std::vector<std::uint32_t>, LoadError> cornersOf(const tinygltf::Primitive& primitive,
                                                            std::size_t vertexCount,
                                                            const std::string& where) const;
    std::optional<LoadError> readNormals(int accessor, ModelMesh& mesh,
                                         const std::string& where) const;
    void applyMaterial(int index, ModelMesh& mesh) const;

    const GltfDocument& document_;
    const tinygltf::Model& gltf_;
};

Result<std::vector<ModelMesh>, LoadError> GltfMeshReader::read(std::size_t index) const {
    std::vector<ModelMesh> parts;
    const tinygltf::Mesh& source = gltf_.meshes[index];
    for (std::size_t i = 0; i < source.primitives.size(); ++i) {
        const tinygltf::Primitive& primitive = source.primitives[i];
        if (!isTriangleMode(primitive.mode) || primitive.attributes.count("POSITION") == 0) {
            continue;
        }
        const std::string where =
            "mesh " + std::to_string(index) + ", primitive " + std::to_string(i);
        Result<ModelMesh, LoadError> mesh = loadPrimitive(primitive, where);
        if (!mesh) {
            return mesh.error();
        }
        mesh->origin = {-1, static_cast<int>(index), static_cast<int>(i), primitive.material};
        mesh->name = source.name.empty() ? "mesh " + std::to_string(index) : source.name;
        if (!mesh->indices.empty()) {
            parts.push_back(std::move(*mesh));
        }
    }
    return parts;
}

Result<std::vector<std::uint32_t>, LoadError>
GltfMeshReader::cornersOf(const tinygltf::Primitive& primitive, std::size_t vertexCount,
                          const std::string& where) const {
    Result<std::vector<std::uint32_t>, LoadError> corners = std::vector<std::uint32_t>();
    if (primitive.indices >= 0) {
        corners = readIndices(document_, primitive.indices);
    } else {
        corners->resize(vertexCount);
        for (std::size_t i = 0; i < vertexCount; ++i) {
            (*corners)[i] = static_cast<std::uint32_t>(i);
        }
    }
    if (!corners) {
        return corners;
    }
    for (const std::uint32_t corner : *corners) {
        if (corner >= vertexCount) {
            return failure(where + ": index " + std::to_string(corner) + " names none of " +
                           std::to_string(vertexCount) + " vertices");
        }
    }
    if (primitive.mode == TINYGLTF_MODE_TRIANGLES && corners->size() % 3 != 0) {
        return failure(where + ": " + std::to_string(corners->size()) +
                       " corners do not make whole triangles");
    }
    return corners;
}

Result<ModelMesh, LoadError> GltfMeshReader::loadPrimitive(const tinygltf::Primitive& primitive,
                                                           const std::string& where) const {
    ModelMesh mesh;
    Result<std::vector<glm::vec3>, LoadError> positions =
        readVectors(document_, primitive.attributes.at("POSITION"));
    if (!positions) {
        return positions.error();
    }
    mesh.positions = std::move(*positions);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        if (!isFinite(mesh.positions[i])) {
            return failure(where + ": the position of vertex " + std::to_string(i) +
                           " is not finite");
        }
    }
    Result<std::vector<std::uint32_t>, LoadError> corners =
        cornersOf(primitive, mesh.positions.size(), where);
    if (!corners) {
        return corners.error();
    }
    mesh.indices = toTriangles(primitive.mode, std::move(*corners));
    const auto normals = primitive.attributes.find("NORMAL");
    if (normals != primitive.attributes.end()) {
        if (std::optional<LoadError> error = readNormals(normals->second, mesh, where)) {
            return *error;
        }
    }
    applyMaterial(primitive.material, mesh);
    return mesh;
}

/// Normals of length zero are replaced by the mean of the faces about the vertex.
std::optional<LoadError> GltfMeshReader::readNormals(int accessor, ModelMesh& mesh,
                                                     const std::string& where) const {
    Result<std::vector<glm::vec3>, LoadError> normals = readVectors(document_, accessor);
    if (!normals) {
        return normals.error();
    }
    if (normals->size() != mesh.positions.size()) {
        return failure(where + ": " + std::to_string(normals->size()) + " normals for " +
                       std::to_string(mesh.positions.size()) + " positions");
    }
    std::vector<glm::vec3> substitutes;
    for (std::size_t i = 0; i < normals->size(); ++i) {
        glm::vec3& normal = (*normals)[i];
        const float length = glm::length(normal);
        if (!std::isfinite(length)) {
            return failure(where + ": the normal of vertex " + std::to_string(i) +
                           " is not finite");
        }
        if (length > 0.0F) {
            normal /= length;
            continue;
        }
        if (substitutes.empty()) {
            substitutes = smoothNormals(mesh.positions, mesh.indices);
        }
        normal = substitutes[i];
    }
    mesh.normals = std::move(*normals);
    return std::nullopt;
}

void GltfMeshReader::applyMaterial(int index, ModelMesh& mesh) const {
    if (index < 0 || static_cast<std::size_t>(index) >= gltf_.materials.size()) {
        return;
    }
    const tinygltf::Material& material = gltf_.materials[static_cast<std::size_t>(index)];
    mesh.doubleSided = material.doubleSided;
    const std::vector<double>& factor = material.pbrMetallicRoughness.baseColorFactor;
    for (std::size_t channel = 0; channel < 4 && factor.size() == 4; ++channel) {
        mesh.baseColour[static_cast<int>(channel)] =
            static_cast<float>(std::clamp(factor[channel], 0.0, 1.0));
    }
}

} // namespace

Result<std::vector<ModelMesh>, LoadError> readGltfMesh(const GltfDocument& document,
                                                       std::size_t index) {
    return GltfMeshReader(document).read(index);
}

} // namespace aolib
