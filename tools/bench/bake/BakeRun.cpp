#include "bench/bake/BakeRun.h"

#include <algorithm>
#include <chrono>
#include <memory>
#include <utility>

#include <aolib/bake/AbstractBaker.h>

namespace aolib::bench {

namespace {

using Baker = std::unique_ptr<bake::AbstractBaker>;
using Clock = std::chrono::steady_clock;

/// The truth's rays are not those that are measured.
constexpr std::uint32_t truthSeed = 1;

Result<Baker> bakerOf(const BakeMesh& mesh, BakeMethodName method, int samples,
                      const ProcAddressLoader& loader) {
    switch (method) {
    case BakeMethodName::Rays: {
        bake::RayOptions options;
        options.rays = samples;
        return bake::createRayBaker(mesh.scene, options);
    }
    case BakeMethodName::Shadow: {
        bake::ShadowOptions options;
        options.directions = samples;
        return bake::createShadowBaker(loader, mesh.scene, options);
    }
    case BakeMethodName::Scatter:
    case BakeMethodName::ScatterUnstretched:
        break;
    }
    bake::ScatterOptions options;
    options.directions = samples;
    options.stretchCorrection = method == BakeMethodName::Scatter;
    return bake::createScatterBaker(loader, mesh.scene, options);
}

Result<bake::BakedMap> mapOf(const Result<Baker>& baker, int size) {
    if (!baker) {
        return baker.status();
    }
    bake::MapOptions options;
    options.width = size;
    options.height = size;
    auto maps = (*baker)->bakeMaps(options, {});
    if (!maps) {
        return maps.status();
    }
    return std::move(maps->front());
}

Result<BakeRow> measured(const BakeMesh& mesh, BakeMethodName method, int samples,
                         const BakePlan& plan, const bake::BakedMap& truth,
                         const ProcAddressLoader& loader) {
    BakeRow row{mesh.name, mesh.triangles, method, samples, 0.0, {}};
    std::vector<double> seconds;
    for (int i = 0; i < plan.repeats; ++i) {
        const Result<Baker> baker = bakerOf(mesh, method, samples, loader);
        const Clock::time_point start = Clock::now();
        const Result<bake::BakedMap> map = mapOf(baker, plan.mapSize);
        if (!map) {
            return map.status();
        }
        seconds.push_back(std::chrono::duration<double>(Clock::now() - start).count());
        row.errors = errorsOf(*map, truth);
    }
    std::sort(seconds.begin(), seconds.end());
    row.seconds = seconds[seconds.size() / 2];
    return row;
}

} // namespace

const char* bakeMethodName(BakeMethodName method) {
    switch (method) {
    case BakeMethodName::Rays:
        return "rays";
    case BakeMethodName::Scatter:
        return "scatter";
    case BakeMethodName::ScatterUnstretched:
        return "scatter-unstretched";
    case BakeMethodName::Shadow:
        return "shadow";
    }
    return "unknown";
}

Result<std::vector<BakeRow>>
runBakePlan(const BakePlan& plan, const ProcAddressLoader& loader,
            const std::function<bool(const std::string& next, double done)>& tell) {
    std::vector<BakeRow> rows;
    const std::size_t cells = plan.meshes.size() * plan.methods.size() * plan.samples.size();
    for (const BakeMesh& mesh : plan.meshes) {
        if (!tell(mesh.name + ", truth", double(rows.size()) / double(cells))) {
            return rows;
        }
        bake::RayOptions rays;
        rays.rays = plan.truthRays;
        rays.seed = truthSeed;
        const Result<bake::BakedMap> truth =
            mapOf(bake::createRayBaker(mesh.scene, rays), plan.mapSize);
        if (!truth) {
            return Status(truth.status().code(), mesh.name + ": " + truth.status().message());
        }
        for (const int samples : plan.samples) {
            for (const BakeMethodName method : plan.methods) {
                const std::string what =
                    mesh.name + ", " + bakeMethodName(method) + ", " + std::to_string(samples);
                if (!tell(what, double(rows.size()) / double(cells))) {
                    return rows;
                }
                const Result<BakeRow> row = measured(mesh, method, samples, plan, *truth, loader);
                if (!row) {
                    return Status(row.status().code(), what + ": " + row.status().message());
                }
                rows.push_back(*row);
            }
        }
    }
    return rows;
}

} // namespace aolib::bench
