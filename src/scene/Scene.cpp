#include "scene/Scene.h"

#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace aolib {

namespace {

/// Distances below this share of a triangle's size are rounding.
constexpr float kOnSurface = 1e-5F;

/// The point of triangle a b c nearest to p (Ericson, Real-Time Collision Detection, 5.1.5).
glm::vec3 nearestOnTriangle(const glm::vec3& p, const glm::vec3& a, const glm::vec3& b,
                            const glm::vec3& c) {
    const glm::vec3 ab = b - a;
    const glm::vec3 ac = c - a;
    const glm::vec3 ap = p - a;
    const float d1 = glm::dot(ab, ap);
    const float d2 = glm::dot(ac, ap);
    if (d1 <= 0.0F && d2 <= 0.0F) {
        return a;
    }
    const glm::vec3 bp = p - b;
    const float d3 = glm::dot(ab, bp);
    const float d4 = glm::dot(ac, bp);
    if (d3 >= 0.0F && d4 <= d3) {
        return b;
    }
    const float vc = d1 * d4 - d3 * d2;
    if (vc <= 0.0F && d1 >= 0.0F && d3 <= 0.0F && d1 > d3) {
        return a + ab * (d1 / (d1 - d3));
    }
    const glm::vec3 cp = p - c;
    const float d5 = glm::dot(ab, cp);
    const float d6 = glm::dot(ac, cp);
    if (d6 >= 0.0F && d5 <= d6) {
        return c;
    }
    const float vb = d5 * d2 - d1 * d6;
    if (vb <= 0.0F && d2 >= 0.0F && d6 <= 0.0F && d2 > d6) {
        return a + ac * (d2 / (d2 - d6));
    }
    const float va = d3 * d6 - d5 * d4;
    if (va <= 0.0F && d4 >= d3 && d5 >= d6 && (d4 - d3) + (d5 - d6) > 0.0F) {
        return b + (c - b) * ((d4 - d3) / ((d4 - d3) + (d5 - d6)));
    }
    const float sum = va + vb + vc;
    return sum > 0.0F ? a + ab * (vb / sum) + ac * (vc / sum) : a;
}

} // namespace

MeshId Scene::add(Mesh mesh) {
    const MeshId id{nextId_++};
    changes_.push_back({id, true, mesh.worldBounds()});
    meshes_.emplace(id, std::move(mesh));
    update();
    return id;
}

AoStatus Scene::unknown(MeshId id) const {
    return {StatusCode::UnknownMesh,
            "no mesh has the id " + std::to_string(static_cast<std::uint32_t>(id))};
}

AoStatus Scene::replace(MeshId id, Mesh mesh) {
    const auto found = meshes_.find(id);
    if (found == meshes_.end()) {
        return unknown(id);
    }
    Bounds region = found->second.worldBounds();
    region.include(mesh.worldBounds());
    found->second = std::move(mesh);
    changes_.push_back({id, true, region});
    update();
    return {};
}

AoStatus Scene::move(MeshId id, const glm::mat4& transform) {
    const auto found = meshes_.find(id);
    if (found == meshes_.end()) {
        return unknown(id);
    }
    if (AoStatus status = checkTransform(transform); !status) {
        return status;
    }
    const Bounds after = transformed(found->second.modelBounds, transform);
    if (!isFinite(after.min) || !isFinite(after.max)) {
        return {StatusCode::InvalidPosition,
                "the transform moves vertices of the mesh beyond the range of float"};
    }
    Bounds region = found->second.worldBounds();
    region.include(after);
    found->second.transform = transform;
    changes_.push_back({id, false, region});
    update();
    return {};
}

AoStatus Scene::remove(MeshId id) {
    const auto found = meshes_.find(id);
    if (found == meshes_.end()) {
        return unknown(id);
    }
    changes_.push_back({id, true, found->second.worldBounds()});
    meshes_.erase(found);
    update();
    return {};
}

std::size_t Scene::triangleCount() const {
    std::size_t count = 0;
    for (const auto& [id, mesh] : meshes_) {
        count += mesh.indices.size() / 3;
    }
    return count;
}

void Scene::setDrawn(const Bounds& box) {
    Bounds region = bounds_;
    drawn_ = box;
    update();
    region.include(bounds_);
    touch(region);
}

void Scene::update() {
    bounds_ = drawn_;
    for (const auto& [id, mesh] : meshes_) {
        bounds_.include(mesh.worldBounds());
    }
}

Scene::Clearance Scene::clearance(const glm::vec3& from) const {
    Clearance best{std::numeric_limits<float>::infinity(), glm::vec3(0.0F, 1.0F, 0.0F)};
    for (const auto& entry : meshes_) {
        const Mesh& mesh = entry.second;
        const Bounds box = mesh.worldBounds();
        if (glm::distance(from, glm::clamp(from, box.min, box.max)) >= best.distance) {
            continue;
        }
        const auto world = [&](std::uint32_t i) {
            return glm::vec3(mesh.transform * glm::vec4(mesh.positions[i], 1.0F));
        };
        for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
            const glm::vec3 a = world(mesh.indices[t]);
            const glm::vec3 b = world(mesh.indices[t + 1]);
            const glm::vec3 c = world(mesh.indices[t + 2]);
            const glm::vec3 offset = from - nearestOnTriangle(from, a, b, c);
            const float distance = glm::length(offset);
            if (distance < best.distance) {
                const glm::vec3 normal = glm::cross(b - a, c - a);
                const float area = glm::length(normal);
                // On the triangle, within rounding, the offset has no direction: take the normal's.
                const float rounding = kOnSurface * (glm::distance(from, a) + glm::distance(b, a));
                best = {distance, distance > rounding ? offset / distance
                                  : area > 0.0F       ? normal / area
                                                      : best.away};
            }
        }
    }
    return best;
}

std::vector<Scene::Change> Scene::takeChanges() {
    return std::exchange(changes_, {});
}

} // namespace aolib
