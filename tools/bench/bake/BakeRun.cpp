#include "bench/bake/BakeRun.h"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <memory>
#include <optional>
#include <utility>

#include <aolib/bake/AbstractBaker.h>

#include "bench/bake/BakedMapFile.h"

namespace aolib::bench {

namespace {

using Baker = std::unique_ptr<bake::AbstractBaker>;
using Clock = std::chrono::steady_clock;

/// The truth's rays are not those that are measured.
constexpr std::uint32_t truthSeed = 1;

Result<bake::BakedMap> mapOf(const Result<Baker>& baker, const bake::MapOptions& options) {
    if (!baker) {
        return baker.status();
    }
    auto maps = (*baker)->bakeMaps(options, {});
    if (!maps) {
        return maps.status();
    }
    return std::move(maps->front());
}

bake::MapOptions mapOptions(const BakePlan& plan) {
    bake::MapOptions options;
    options.width = plan.mapSize;
    options.height = plan.mapSize;
    return options;
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

Result<BakeRow> measured(const BakeMesh& mesh, BakeMethodName method, int samples,
                         const BakePlan& plan, const bake::BakedMap& truth,
                         const ProcAddressLoader& loader) {
    BakeRow row{mesh.name, mesh.triangles, method, samples, plan.mapSize, 0.0, 0.0, {}};
    std::vector<double> seconds;
    std::vector<double> processor;
    for (int i = 0; i < plan.repeats; ++i) {
        const Result<Baker> baker = bakerOf(mesh, method, samples, loader);
        const Clock::time_point start = Clock::now();
        const std::clock_t used = std::clock();
        const Result<bake::BakedMap> map = mapOf(baker, mapOptions(plan));
        if (!map) {
            return map.status();
        }
        seconds.push_back(std::chrono::duration<double>(Clock::now() - start).count());
        processor.push_back(double(std::clock() - used) / CLOCKS_PER_SEC);
        row.errors = errorsOf(*map, truth);
    }
    row.seconds = median(seconds);
    row.processor = median(processor);
    return row;
}

/// The texels of a map that a truth is traced at.
Result<bake::MapOptions> truthMap(const Result<Baker>& baker, const BakePlan& plan) {
    bake::MapOptions options = mapOptions(plan);
    if (plan.truthTexels == 0) {
        return options;
    }
    options.padding = 0;
    options.fill = false;
    options.wanted.assign(
        static_cast<std::size_t>(plan.mapSize) * static_cast<std::size_t>(plan.mapSize), 0);
    const Result<bake::BakedMap> kinds = mapOf(baker, options);
    if (!kinds) {
        return kinds.status();
    }
    options.wanted = sampledTexels(*kinds, plan.truthTexels);
    return options;
}

/// A truth, from a file where an earlier run has left it.
Result<bake::BakedMap> truthOf(const BakeMesh& mesh, const BakePlan& plan,
                               const std::filesystem::path& folder) {
    std::string name =
        mesh.name + "-" + std::to_string(plan.mapSize) + "-" + std::to_string(plan.truthRays);
    if (plan.truthTexels > 0) {
        name += "-" + std::to_string(plan.truthTexels);
    }
    if (!folder.empty()) {
        if (std::optional<bake::BakedMap> kept = readBakedMap(folder / name)) {
            return std::move(*kept);
        }
    }
    bake::RayOptions rays;
    rays.rays = plan.truthRays;
    rays.seed = truthSeed;
    const Result<Baker> baker = bake::createRayBaker(mesh.scene, rays);
    const Result<bake::MapOptions> options = truthMap(baker, plan);
    if (!options) {
        return options.status();
    }
    Result<bake::BakedMap> made = mapOf(baker, *options);
    if (made && !folder.empty()) {
        writeBakedMap(folder / name, *made);
    }
    return made;
}

const BakeRow* rowOf(const std::vector<BakeRow>& rows, const BakeRow& wanted) {
    const auto found = std::find_if(rows.begin(), rows.end(), [&](const BakeRow& row) {
        return row.mesh == wanted.mesh && row.method == wanted.method &&
               row.samples == wanted.samples && row.mapSize == wanted.mapSize;
    });
    return found != rows.end() ? &*found : nullptr;
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

Result<std::unique_ptr<bake::AbstractBaker>> bakerOf(const BakeMesh& mesh, BakeMethodName method,
                                                     int samples, const ProcAddressLoader& loader) {
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

Result<std::vector<BakeRow>>
runBakePlan(const BakePlan& plan, const BakeMemory& memory, const ProcAddressLoader& loader,
            const std::function<bool(const std::string& next, double done)>& tell) {
    std::vector<BakeRow> rows = memory.known;
    std::size_t done = 0;
    const std::size_t cells = plan.meshes.size() * plan.methods.size() * plan.samples.size();
    for (const BakeMesh& mesh : plan.meshes) {
        std::optional<bake::BakedMap> truth;
        for (const int samples : plan.samples) {
            for (const BakeMethodName method : plan.methods) {
                const double share = double(done++) / double(cells);
                if (rowOf(rows, {mesh.name, 0, method, samples, plan.mapSize, 0.0, 0.0, {}})) {
                    continue;
                }
                if (!truth) {
                    if (!tell(mesh.name + ", truth", share)) {
                        return rows;
                    }
                    Result<bake::BakedMap> made = truthOf(mesh, plan, memory.truths);
                    if (!made) {
                        return Status(made.status().code(),
                                      mesh.name + ": " + made.status().message());
                    }
                    truth = std::move(*made);
                }
                const std::string what =
                    mesh.name + ", " + bakeMethodName(method) + ", " + std::to_string(samples);
                if (!tell(what, share)) {
                    return rows;
                }
                const Result<BakeRow> row = measured(mesh, method, samples, plan, *truth, loader);
                if (!row) {
                    return Status(row.status().code(), what + ": " + row.status().message());
                }
                rows.push_back(*row);
                if (memory.keep) {
                    memory.keep(rows);
                }
            }
        }
    }
    return rows;
}

} // namespace aolib::bench
