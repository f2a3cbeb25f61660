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

/// A line of the table that is being measured.
struct Cell {
    BakeRow row;
    std::vector<double> seconds;
    std::vector<double> processor;
};

AoStatus measure(Cell& cell, const BakeMesh& mesh, const BakePlan& plan,
                 const bake::BakedMap& truth, const ProcAddressLoader& loader) {
    const Result<Baker> baker = bakerOf(mesh, cell.row.method, cell.row.samples, loader);
    const Clock::time_point start = Clock::now();
    const std::clock_t used = std::clock();
    const Result<bake::BakedMap> map = mapOf(baker, mapOptions(plan));
    if (!map) {
        return map.status();
    }
    cell.seconds.push_back(std::chrono::duration<double>(Clock::now() - start).count());
    cell.processor.push_back(double(std::clock() - used) / CLOCKS_PER_SEC);
    cell.row.errors = errorsOf(*map, truth);
    cell.row.seconds = median(cell.seconds);
    cell.row.processor = median(cell.processor);
    return {};
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

namespace {

/// The lines of a mesh that an earlier run has not left.
std::vector<Cell> cellsOf(const BakeMesh& mesh, const BakePlan& plan,
                          const std::vector<BakeRow>& known) {
    std::vector<Cell> cells;
    for (const int samples : plan.samples) {
        for (const BakeMethodName method : plan.methods) {
            const BakeRow row{mesh.name, mesh.triangles, method, samples, plan.mapSize, 0.0, 0.0,
                              {}};
            if (rowOf(known, row) == nullptr) {
                cells.push_back({row, {}, {}});
            }
        }
    }
    return cells;
}

} // namespace

Result<std::vector<BakeRow>>
runBakePlan(const BakePlan& plan, const BakeMemory& memory, const ProcAddressLoader& loader,
            const std::function<bool(const std::string& next, double done)>& tell) {
    std::vector<BakeRow> rows = memory.known;
    for (std::size_t number = 0; number < plan.meshes.size(); ++number) {
        const BakeMesh& mesh = plan.meshes[number];
        std::vector<Cell> cells = cellsOf(mesh, plan, rows);
        if (cells.empty()) {
            continue;
        }
        const auto share = [&](double fraction) {
            return (double(number) + fraction) / double(plan.meshes.size());
        };
        if (!tell(mesh.name + ", truth", share(0.0))) {
            return rows;
        }
        const Result<bake::BakedMap> truth = truthOf(mesh, plan, memory.truths);
        if (!truth) {
            return AoStatus(truth.status().code(), mesh.name + ": " + truth.status().message());
        }
        // All lines by turns: what else the machine does meets them alike.
        const std::size_t count = cells.size() * static_cast<std::size_t>(plan.repeats);
        for (std::size_t i = 0; i < count; ++i) {
            Cell& cell = cells[i % cells.size()];
            const std::string what = mesh.name + ", " + bakeMethodName(cell.row.method) + ", " +
                                     std::to_string(cell.row.samples);
            if (!tell(what, share(double(i) / double(count)))) {
                return rows;
            }
            if (AoStatus status = measure(cell, mesh, plan, *truth, loader); !status) {
                return AoStatus(status.code(), what + ": " + status.message());
            }
            if (i + cells.size() >= count) {
                rows.push_back(cell.row);
                if (memory.keep) {
                    memory.keep(rows);
                }
            }
        }
    }
    return rows;
}

} // namespace aolib::bench
