#include "scene/WorldTriangles.h"

#include <algorithm>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

namespace aolib {

namespace {

/// The largest magnitude among a matrix's elements.
double largest(const glm::dmat3& m) {
    const glm::dvec3 rows = glm::max(glm::abs(m[0]), glm::max(glm::abs(m[1]), glm::abs(m[2])));
    return std::max({rows.x, rows.y, rows.z});
}

void appendNormals(std::vector<glm::vec3>& out, const Mesh& mesh) {
    const glm::dmat3 matrix = normalMatrix(mesh.transform);
    for (const glm::vec3& given : mesh.normals) {
        const glm::dvec3 normal = matrix * glm::dvec3(given);
        const double length = glm::length(normal);
        out.push_back(length > 0.0 ? glm::vec3(normal / length) : glm::vec3(0.0F));
    }
    out.resize(out.size() + mesh.positions.size() - mesh.normals.size(), glm::vec3(0.0F));
}

} // namespace

/// By the matrix of cofactors, which is the inverse transpose times the determinant.
glm::dmat3 normalMatrix(const glm::mat4& transform) {
    const glm::dmat3 linear{glm::dmat4(transform)};
    const double size = largest(linear);
    if (!(size > 0.0)) {
        return glm::dmat3(0.0);
    }
    const glm::dmat3 m = linear / size; // so that products stay within range
    const glm::dmat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]),
                               glm::cross(m[0], m[1]));
    const double most = largest(cofactors);
    if (!(most > 0.0)) {
        return glm::dmat3(0.0);
    }
    return cofactors / (glm::determinant(m) < 0.0 ? -most : most);
}

TriangleMesh worldTriangles(const Scene& scene) {
    const auto& meshes = scene.meshes();
    const bool withNormals = std::any_of(meshes.begin(), meshes.end(), [](const auto& mesh) {
        return !mesh.second.normals.empty();
    });
    TriangleMesh all;
    for (const auto& [id, mesh] : meshes) {
        const auto first = static_cast<std::uint32_t>(all.positions.size());
        const glm::dmat4 transform(mesh.transform);
        for (const glm::vec3& position : mesh.positions) {
            all.positions.emplace_back(glm::dvec3(transform * glm::dvec4(position, 1.0)));
        }
        if (withNormals) {
            appendNormals(all.normals, mesh);
        }
        for (const std::uint32_t index : mesh.indices) {
            all.indices.push_back(first + index);
        }
    }
    return all;
}

} // namespace aolib
