#include "TestScenes.h"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace aolib::test {

namespace {

std::uint32_t vertexCount(const TriangleMesh& mesh) {
    return static_cast<std::uint32_t>(mesh.positions.size());
}

} // namespace

void addQuad(TriangleMesh& mesh, const glm::dvec3& corner, const glm::dvec3& a,
             const glm::dvec3& b) {
    const std::uint32_t first = vertexCount(mesh);
    for (const glm::dvec3& p : {corner, corner + a, corner + a + b, corner + b}) {
        mesh.positions.emplace_back(p);
    }
    for (const std::uint32_t i : {0U, 1U, 2U, 0U, 2U, 3U}) {
        mesh.indices.push_back(first + i);
    }
}

TriangleMesh floorAndWall(double height, double scale, const glm::dvec3& offset) {
    constexpr double length = 2048.0;
    TriangleMesh mesh;
    addQuad(mesh, offset + scale * glm::dvec3(0.0, 0.0, -length),
            scale * glm::dvec3(0.0, 0.0, 2.0 * length), scale * glm::dvec3(length, 0.0, 0.0));
    addQuad(mesh, offset + scale * glm::dvec3(0.0, 0.0, -length),
            scale * glm::dvec3(0.0, height, 0.0), scale * glm::dvec3(0.0, 0.0, 2.0 * length));
    return mesh;
}

TriangleMesh disc(double radius, double height, bool facingUp) {
    constexpr std::uint32_t sides = 2048;
    const double step = 2.0 * std::numbers::pi / double(sides);
    const double corner = radius * std::sqrt(step / std::sin(step));
    TriangleMesh mesh;
    mesh.positions.emplace_back(glm::dvec3(0.0, height, 0.0));
    for (std::uint32_t i = 0; i < sides; ++i) {
        const double angle = double(i) * step;
        mesh.positions.emplace_back(
            glm::dvec3(corner * std::cos(angle), height, corner * std::sin(angle)));
        const std::uint32_t here = 1 + i;
        const std::uint32_t there = 1 + (i + 1) % sides;
        mesh.indices.insert(mesh.indices.end(),
                            {0, facingUp ? there : here, facingUp ? here : there});
    }
    return mesh;
}

TriangleMesh sphere(double radius) {
    TriangleMesh mesh = smoothSphere(radius, 256, 512);
    mesh.normals.clear();
    return mesh;
}

TriangleMesh smoothSphere(double radius, std::uint32_t rows, std::uint32_t columns) {
    TriangleMesh mesh;
    for (std::uint32_t row = 0; row <= rows; ++row) {
        const double polar = std::numbers::pi * double(row) / double(rows);
        for (std::uint32_t column = 0; column < columns; ++column) {
            const double azimuth = 2.0 * std::numbers::pi * double(column) / double(columns);
            const glm::dvec3 outward(std::sin(polar) * std::cos(azimuth),
                                     std::sin(polar) * std::sin(azimuth), std::cos(polar));
            mesh.positions.emplace_back(radius * outward);
            mesh.normals.emplace_back(outward);
        }
    }
    for (std::uint32_t row = 0; row < rows; ++row) {
        for (std::uint32_t column = 0; column < columns; ++column) {
            const std::uint32_t next = (column + 1) % columns;
            const std::uint32_t upper = row * columns;
            const std::uint32_t lower = upper + columns;
            mesh.indices.insert(mesh.indices.end(), {upper + column, lower + column, lower + next});
            mesh.indices.insert(mesh.indices.end(), {upper + column, lower + next, upper + next});
        }
    }
    return mesh;
}

TriangleMesh box() {
    TriangleMesh mesh;
    const glm::dvec3 x(2.0, 0.0, 0.0);
    const glm::dvec3 y(0.0, 2.0, 0.0);
    const glm::dvec3 z(0.0, 0.0, 2.0);
    const glm::dvec3 low(-1.0);
    addQuad(mesh, low, y, x);
    addQuad(mesh, low, z, y);
    addQuad(mesh, low, x, z);
    addQuad(mesh, low + z, x, y);
    addQuad(mesh, low + x, y, z);
    addQuad(mesh, low + y, z, x);
    return mesh;
}

RayScene sceneOf(TriangleMesh mesh) {
    Result<RayScene> scene = RayScene::create(std::move(mesh));
    if (!scene) {
        throw std::runtime_error(scene.status().message());
    }
    return std::move(*scene);
}

VisibilityEstimate visibilityAt(const RayScene& scene, const Receiver& receiver,
                                const TraceSettings& settings) {
    const Result<VisibilityTracer> tracer = VisibilityTracer::create(scene, settings);
    if (!tracer) {
        throw std::runtime_error(tracer.status().message());
    }
    return tracer->estimate(receiver, 0);
}

TraceSettings tracing(int rays, Falloff falloff, double radius) {
    TraceSettings settings;
    settings.rays = rays;
    settings.falloff = falloff;
    settings.radius = radius;
    return settings;
}

} // namespace aolib::test
