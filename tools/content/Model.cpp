#include "content/Model.h"

#include <algorithm>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

namespace aolib {
namespace {

const glm::vec3 up{0.0F, 1.0F, 0.0F};

glm::vec3 unitOr(const glm::vec3& v, const glm::vec3& fallback) {
    const float length = glm::length(v);
    return length > 0.0F ? v / length : fallback;
}

/// The inverse transpose up to a positive factor: the matrix of cofactors, which exists for
/// singular matrices too, turned so that mirroring keeps normals on their side.
glm::mat3 normalMatrix(const glm::mat4& transform) {
    const glm::mat3 m(transform);
    const glm::mat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]),
                              glm::cross(m[0], m[1]));
    return glm::determinant(m) < 0.0F ? -cofactors : cofactors;
}

glm::vec3 place(const glm::mat4& transform, const glm::vec3& p) {
    return glm::vec3(transform * glm::vec4(p, 1.0F));
}

void appendShared(TriangleMesh& out, const ModelMesh& mesh, bool withNormals, bool mirrored) {
    const auto base = static_cast<std::uint32_t>(out.positions.size());
    for (const glm::vec3& p : mesh.positions) {
        out.positions.push_back(place(mesh.transform, p));
    }
    if (withNormals) {
        const glm::mat3 matrix = normalMatrix(mesh.transform);
        for (const glm::vec3& n : mesh.normals) {
            out.normals.push_back(unitOr(matrix * n, glm::vec3(0.0F)));
        }
    }
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        out.indices.push_back(base + mesh.indices[i]);
        out.indices.push_back(base + mesh.indices[mirrored ? i + 2 : i + 1]);
        out.indices.push_back(base + mesh.indices[mirrored ? i + 1 : i + 2]);
    }
}

void appendFlat(TriangleMesh& out, const ModelMesh& mesh, bool mirrored) {
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const glm::vec3 a = place(mesh.transform, mesh.positions[mesh.indices[i]]);
        glm::vec3 b = place(mesh.transform, mesh.positions[mesh.indices[i + 1]]);
        glm::vec3 c = place(mesh.transform, mesh.positions[mesh.indices[i + 2]]);
        if (mirrored) {
            std::swap(b, c);
        }
        const glm::vec3 normal = unitOr(glm::cross(b - a, c - a), up);
        for (const glm::vec3& p : {a, b, c}) {
            out.indices.push_back(static_cast<std::uint32_t>(out.positions.size()));
            out.positions.push_back(p);
            out.normals.push_back(normal);
        }
    }
}

} // namespace

Bounds Model::bounds() const {
    Bounds result;
    for (const ModelMesh& mesh : meshes) {
        for (const std::uint32_t index : mesh.indices) {
            result.include(place(mesh.transform, mesh.positions[index]));
        }
    }
    return result;
}

std::size_t Model::triangleCount() const {
    std::size_t count = 0;
    for (const ModelMesh& mesh : meshes) {
        count += mesh.triangleCount();
    }
    return count;
}

TriangleMesh Model::flattened() const {
    const bool withNormals = std::any_of(
        meshes.begin(), meshes.end(), [](const ModelMesh& mesh) { return !mesh.normals.empty(); });
    TriangleMesh out;
    for (const ModelMesh& mesh : meshes) {
        const bool mirrored = glm::determinant(glm::mat3(mesh.transform)) < 0.0F;
        if (withNormals && mesh.normals.empty()) {
            appendFlat(out, mesh, mirrored);
        } else {
            appendShared(out, mesh, withNormals, mirrored);
        }
    }
    return out;
}

std::vector<glm::vec3> smoothNormals(const std::vector<glm::vec3>& positions,
                                     const std::vector<std::uint32_t>& indices) {
    std::vector<glm::vec3> sums(positions.size(), glm::vec3(0.0F));
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
        const glm::vec3& a = positions[indices[i]];
        const glm::vec3 doubledArea =
            glm::cross(positions[indices[i + 1]] - a, positions[indices[i + 2]] - a);
        for (std::size_t corner = 0; corner < 3; ++corner) {
            sums[indices[i + corner]] += doubledArea;
        }
    }
    for (glm::vec3& normal : sums) {
        normal = unitOr(normal, up);
    }
    return sums;
}

} // namespace aolib
