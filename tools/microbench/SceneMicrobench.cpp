// The scene's own work on the CPU: finding solids, the clearance about a point, and rays.
#include <cmath>
#include <utility>

#include <benchmark/benchmark.h>

#include "bench/OpenedScene.h"
#include "scene/Scene.h"
#include "scene/Solids.h"

namespace aolib {
namespace {

/// A generated scene as one mesh; scene 0 is the town, 1 the room.
Mesh meshOf(std::int64_t number) {
    const char* const name = number == 0 ? "town" : "room";
    const Result<bench::OpenedScene, LoadError> opened =
        bench::openBenchScene({name, bench::SceneKind::Generated, false});
    const TriangleMesh& triangles = opened->rays.mesh();
    Result<Mesh> mesh = makeMesh({triangles.positions, {}, triangles.indices});
    return std::move(*mesh);
}

void FindSolids(benchmark::State& state) {
    const Mesh mesh = meshOf(state.range(0));
    for (auto turn : state) {
        benchmark::DoNotOptimize(findSolids(mesh).count());
    }
    state.SetItemsProcessed(state.iterations() *
                            static_cast<std::int64_t>(mesh.indices.size() / 3));
}
BENCHMARK(FindSolids)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

void SceneClearance(benchmark::State& state) {
    Scene scene;
    const MeshId id = scene.add(meshOf(state.range(0)));
    benchmark::DoNotOptimize(id);
    const glm::vec3 center = scene.bounds().center();
    for (auto turn : state) {
        benchmark::DoNotOptimize(scene.clearance(center).distance);
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(scene.triangleCount()));
}
BENCHMARK(SceneClearance)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

void ShadowRays(benchmark::State& state) {
    const Result<bench::OpenedScene, LoadError> opened =
        bench::openBenchScene({"town", bench::SceneKind::Generated, false});
    const glm::dvec3 eye(opened->cameras.front().eye);
    double angle = 0.0;
    for (auto turn : state) {
        angle += 0.1;
        const glm::dvec3 direction(std::cos(angle), 0.3 * std::sin(7.0 * angle), std::sin(angle));
        benchmark::DoNotOptimize(
            opened->rays.occluded(eye, direction, 0.0, 0.1 * opened->diagonal));
    }
    state.SetItemsProcessed(state.iterations());
}
BENCHMARK(ShadowRays);

} // namespace
} // namespace aolib
