#include "bake/geometry/BakeGeometry.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <glm/geometric.hpp>

#include "scene/Finite.h"

namespace aolib::bake {

namespace {

constexpr int mostMaps = 4096;

AoStatus fault(StatusCode code, std::size_t surface, const std::string& reason) {
    return {code, "surface " + std::to_string(surface) + ": " + reason};
}

AoStatus checkSurface(const Surface& surface, std::size_t number) {
    const std::size_t vertices = surface.positions.size();
    if (surface.indices.size() % 3 != 0) {
        return fault(StatusCode::IncompletePrimitive, number,
                     std::to_string(surface.indices.size()) + " indices are not whole triangles");
    }
    for (const std::uint32_t index : surface.indices) {
        if (index >= vertices) {
            return fault(StatusCode::InvalidIndex, number,
                         "index " + std::to_string(index) + " of only " + std::to_string(vertices) +
                             " vertices");
        }
    }
    for (std::size_t i = 0; i < vertices; ++i) {
        if (!isFinite(surface.positions[i])) {
            return fault(StatusCode::InvalidPosition, number,
                         "position " + std::to_string(i) + " is not finite");
        }
    }
    if (!surface.normals.empty() && surface.normals.size() != vertices) {
        return fault(StatusCode::InvalidNormal, number,
                     std::to_string(surface.normals.size()) + " normals for " +
                         std::to_string(vertices) + " positions");
    }
    if (!surface.uvs.empty() && surface.uvs.size() != vertices) {
        return fault(StatusCode::InvalidOption, number,
                     std::to_string(surface.uvs.size()) + " UVs for " + std::to_string(vertices) +
                         " positions");
    }
    if (surface.map < -1 || surface.map >= mostMaps) {
        return fault(StatusCode::InvalidOption, number,
                     "map is " + std::to_string(surface.map) + ", must be -1 to " +
                         std::to_string(mostMaps - 1));
    }
    return {};
}

} // namespace

glm::dvec3 unitOrZero(const glm::dvec3& v) {
    const double length = glm::length(v);
    return length > 0.0 && std::isfinite(length) ? v / length : glm::dvec3(0.0);
}

Result<BakeGeometry> BakeGeometry::create(BakeScene scene) {
    BakeGeometry geometry;
    geometry.scene_ = std::move(scene);
    geometry.up_ = unitOrZero(glm::dvec3(geometry.scene_.up));
    if (AoStatus status = geometry.check(); !status) {
        return status;
    }
    geometry.firstTriangle_.push_back(0);
    for (const Surface& surface : geometry.scene_.surfaces) {
        geometry.firstTriangle_.push_back(geometry.firstTriangle_.back() +
                                          surface.indices.size() / 3);
        for (const std::uint32_t index : surface.indices) {
            geometry.bounds_.include(surface.positions[index]);
        }
    }
    if (geometry.triangleCount() == 0) {
        return AoStatus(StatusCode::EmptyMesh, "there are no triangles to bake");
    }
    return geometry;
}

AoStatus BakeGeometry::check() const {
    if (up_ == glm::dvec3(0.0)) {
        return {StatusCode::InvalidOption, "up is zero or not finite"};
    }
    if (scene_.ground && !std::isfinite(*scene_.ground)) {
        return {StatusCode::InvalidOption, "ground is not finite"};
    }
    for (std::size_t i = 0; i < scene_.surfaces.size(); ++i) {
        if (AoStatus status = checkSurface(scene_.surfaces[i], i); !status) {
            return status;
        }
    }
    return {};
}

TriangleName BakeGeometry::triangle(std::size_t number) const {
    const auto behind = std::upper_bound(firstTriangle_.begin(), firstTriangle_.end(), number);
    const auto surface = static_cast<std::size_t>(behind - firstTriangle_.begin()) - 1;
    return {static_cast<std::uint32_t>(surface),
            static_cast<std::uint32_t>(number - firstTriangle_[surface])};
}

std::optional<SurfacePoint> BakeGeometry::point(const TriangleName& name, double b1,
                                                double b2) const {
    const Surface& surface = scene_.surfaces[name.surface];
    const std::uint32_t* index = &surface.indices[std::size_t{name.triangle} * 3];
    const glm::dvec3 a(surface.positions[index[0]]);
    const glm::dvec3 ab = glm::dvec3(surface.positions[index[1]]) - a;
    const glm::dvec3 ac = glm::dvec3(surface.positions[index[2]]) - a;
    SurfacePoint result;
    result.position = a + b1 * ab + b2 * ac;
    result.plane = unitOrZero(glm::cross(ab, ac));
    if (!surface.normals.empty()) {
        result.normal = unitOrZero((1.0 - b1 - b2) * glm::dvec3(surface.normals[index[0]]) +
                                   b1 * glm::dvec3(surface.normals[index[1]]) +
                                   b2 * glm::dvec3(surface.normals[index[2]]));
    }
    if (result.normal == glm::dvec3(0.0)) {
        result.normal = result.plane;
    }
    if (result.plane == glm::dvec3(0.0)) {
        result.plane = result.normal;
    }
    if (result.normal == glm::dvec3(0.0)) {
        return std::nullopt;
    }
    if (glm::dot(result.plane, result.normal) < 0.0) {
        result.plane = -result.plane;
    }
    return result;
}

TriangleMesh BakeGeometry::occluders() const {
    TriangleMesh mesh;
    mesh.indices.reserve(triangleCount() * 3);
    for (const Surface& surface : scene_.surfaces) {
        const auto base = static_cast<std::uint32_t>(mesh.positions.size());
        mesh.positions.insert(mesh.positions.end(), surface.positions.begin(),
                              surface.positions.end());
        for (const std::uint32_t index : surface.indices) {
            mesh.indices.push_back(base + index);
        }
    }
    return mesh;
}

} // namespace aolib::bake
