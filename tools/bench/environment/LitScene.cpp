#include "bench/environment/LitScene.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

#include "content/Tessellation.h"

namespace aolib::bench {

namespace {

/// A disc of rings, close together where the model stands: the first as wide as it is.
ModelMesh groundDisc(const Bounds& bounds) {
    constexpr int segments = 144;
    constexpr int nearRings = 72;
    constexpr int farRings = 24;
    constexpr float growth = 1.12F;
    ModelMesh mesh;
    mesh.name = "ground";
    const glm::vec3 centre(bounds.center().x, bounds.min.y, bounds.center().z);
    mesh.positions.push_back(centre);
    float radius = 0.0F;
    float step = bounds.diagonal() / float(nearRings);
    for (int ring = 0; ring < nearRings + farRings; ++ring) {
        step *= ring < nearRings ? 1.0F : growth;
        radius += step;
        for (int i = 0; i < segments; ++i) {
            const float turn = 2.0F * std::numbers::pi_v<float> * float(i) / float(segments);
            mesh.positions.push_back(centre +
                                     radius * glm::vec3(std::cos(turn), 0.0F, -std::sin(turn)));
        }
    }
    mesh.normals.assign(mesh.positions.size(), glm::vec3(0.0F, 1.0F, 0.0F));
    for (std::uint32_t i = 0; i < segments; ++i) {
        const std::uint32_t next = (i + 1) % segments;
        mesh.indices.insert(mesh.indices.end(), {0, 1 + i, 1 + next});
        for (std::uint32_t ring = 1; ring < nearRings + farRings; ++ring) {
            const std::uint32_t inner = 1 + (ring - 1) * segments;
            const std::uint32_t outer = inner + segments;
            mesh.indices.insert(mesh.indices.end(), {inner + i, outer + i, outer + next, inner + i,
                                                     outer + next, inner + next});
        }
    }
    return mesh;
}

std::vector<glm::vec4> together(const bake::BakedVertices& values) {
    std::vector<glm::vec4> result;
    result.reserve(values.visibility.size());
    for (std::size_t i = 0; i < values.visibility.size(); ++i) {
        result.emplace_back(values.bentNormal[i], values.visibility[i]);
    }
    return result;
}

Result<std::vector<bake::BakedVertices>> bakeVertices(const LitScene& scene, int rays,
                                                      bake::Measure measure,
                                                      const bake::BakeProgress& progress) {
    bake::BakeScene input;
    for (const host::LitPiece& piece : scene.pieces) {
        input.surfaces.push_back({piece.positions, piece.normals, {}, piece.indices, 0});
    }
    bake::RayOptions options;
    options.rays = rays;
    options.measure = measure;
    options.sectors = measure == bake::Measure::Cosine;
    const auto baker = bake::createRayBaker(std::move(input), options);
    if (!baker) {
        return baker.status();
    }
    return (*baker)->bakeVertices({}, progress);
}

} // namespace

TriangleMesh LitScene::mesh() const {
    TriangleMesh all;
    for (const host::LitPiece& piece : pieces) {
        const auto first = static_cast<std::uint32_t>(all.positions.size());
        all.positions.insert(all.positions.end(), piece.positions.begin(), piece.positions.end());
        all.normals.insert(all.normals.end(), piece.normals.begin(), piece.normals.end());
        for (const std::uint32_t index : piece.indices) {
            all.indices.push_back(first + index);
        }
    }
    return all;
}

std::size_t LitScene::vertices() const {
    std::size_t count = 0;
    for (const host::LitPiece& piece : pieces) {
        count += piece.positions.size();
    }
    return count;
}

Result<LitScene> bakeLitScene(Model model, const LitSceneOptions& options,
                              const bake::BakeProgress& progress) {
    const Bounds bounds = model.bounds();
    LitScene scene;
    scene.name = model.name;
    model = tessellated(std::move(model), static_cast<float>(options.edge) * bounds.diagonal(),
                        options.mostTriangles);
    if (options.ground) {
        model.meshes.push_back(groundDisc(bounds));
    }
    for (ModelMesh& mesh : model.meshes) {
        if (mesh.indices.empty()) {
            continue;
        }
        if (mesh.normals.empty()) {
            mesh.normals = smoothNormals(mesh.positions, mesh.indices);
        }
        host::LitPiece piece;
        piece.colour = glm::vec3(mesh.baseColour);
        Model alone;
        alone.meshes.push_back(std::move(mesh));
        TriangleMesh placed = alone.flattened();
        piece.positions = std::move(placed.positions);
        piece.normals = std::move(placed.normals);
        piece.indices = std::move(placed.indices);
        scene.pieces.push_back(std::move(piece));
    }
    const auto begin = std::chrono::steady_clock::now();
    for (const bake::Measure measure : {bake::Measure::Cosine, bake::Measure::SolidAngle}) {
        const bool first = measure == bake::Measure::Cosine;
        const auto half = [&](double done) {
            return !progress || progress(0.5 * done + (first ? 0.0 : 0.5));
        };
        const auto values = bakeVertices(scene, options.rays, measure, half);
        if (!values) {
            return values.status();
        }
        for (std::size_t i = 0; i < scene.pieces.size(); ++i) {
            (first ? scene.pieces[i].open : scene.pieces[i].plain) = together((*values)[i]);
            if (first) {
                scene.pieces[i].sectors = (*values)[i].sectors;
            }
        }
    }
    scene.bakeSeconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return scene;
}

} // namespace aolib::bench
