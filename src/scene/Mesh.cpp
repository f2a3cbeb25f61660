#include "scene/Mesh.h"

#include <cmath>
#include <sstream>
#include <string>

namespace aolib {

namespace {

std::string text(const glm::vec3& v) {
    std::ostringstream out;
    out << '(' << v.x << ", " << v.y << ", " << v.z << ')';
    return out.str();
}

} // namespace

AoStatus checkTransform(const glm::mat4& transform) {
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
            if (!std::isfinite(transform[column][row])) {
                return {StatusCode::InvalidPosition, "the transform's element in column " +
                                                         std::to_string(column) + ", row " +
                                                         std::to_string(row) + " is not finite"};
            }
        }
    }
    return {};
}

Result<Mesh> makeMesh(const MeshData& data) {
    if (data.positions.empty() || data.indices.empty()) {
        return AoStatus(StatusCode::EmptyMesh,
                        "a mesh needs vertices and triangles; this one has " +
                            std::to_string(data.positions.size()) + " vertices and " +
                            std::to_string(data.indices.size()) + " indices");
    }
    if (data.indices.size() % 3 != 0) {
        return AoStatus(StatusCode::IncompletePrimitive, "triangles need three indices each; " +
                                                             std::to_string(data.indices.size()) +
                                                             " is not a multiple of three");
    }
    if (!data.normals.empty() && data.normals.size() != data.positions.size()) {
        return AoStatus(StatusCode::InvalidNormal, std::to_string(data.normals.size()) +
                                                       " normals for " +
                                                       std::to_string(data.positions.size()) +
                                                       " positions; give none or one per position");
    }
    if (AoStatus status = checkTransform(data.transform); !status) {
        return status;
    }
    Mesh mesh;
    for (std::size_t i = 0; i < data.positions.size(); ++i) {
        if (!isFinite(data.positions[i])) {
            return AoStatus(StatusCode::InvalidPosition, "position " + std::to_string(i) + " is " +
                                                             text(data.positions[i]) +
                                                             "; it must be finite");
        }
        mesh.modelBounds.include(data.positions[i]);
    }
    for (std::size_t i = 0; i < data.normals.size(); ++i) {
        if (!isFinite(data.normals[i])) {
            return AoStatus(StatusCode::InvalidNormal, "normal " + std::to_string(i) + " is " +
                                                           text(data.normals[i]) +
                                                           "; it must be finite");
        }
    }
    for (std::size_t i = 0; i < data.indices.size(); ++i) {
        if (data.indices[i] >= data.positions.size()) {
            return AoStatus(StatusCode::InvalidIndex,
                            "index " + std::to_string(i) + " is " +
                                std::to_string(data.indices[i]) + "; the mesh has " +
                                std::to_string(data.positions.size()) + " vertices");
        }
    }
    mesh.transform = data.transform;
    if (const Bounds world = mesh.worldBounds(); !isFinite(world.min) || !isFinite(world.max)) {
        return AoStatus(StatusCode::InvalidPosition,
                        "the transform moves vertices of the mesh beyond the range of float");
    }
    mesh.positions.assign(data.positions.begin(), data.positions.end());
    mesh.normals.assign(data.normals.begin(), data.normals.end());
    mesh.indices.assign(data.indices.begin(), data.indices.end());
    return mesh;
}

} // namespace aolib
