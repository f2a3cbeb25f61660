#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <aolib/ProcAddressLoader.h>
#include <aolib/Status.h>
#include <aolib/bake/AbstractBaker.h>
#include <aolib/bake/BakeScene.h>

#include "bench/bake/MapErrors.h"

namespace aolib::bench {

enum class BakeMethodName { Rays, Scatter, ScatterUnstretched, Shadow };
const char* bakeMethodName(BakeMethodName method);

/// A mesh of the bakers' table.
struct BakeMesh {
    std::string name;
    std::size_t triangles = 0;
    bake::BakeScene scene; ///< one map
};

/// What is measured: every mesh by every method with every number of samples.
struct BakePlan {
    std::vector<BakeMesh> meshes;
    std::vector<BakeMethodName> methods;
    std::vector<int> samples; ///< rays per texel, or directions
    int mapSize = 512;        ///< texels
    int truthRays = 4096;     ///< per texel, of another seed than those measured
    int truthTexels = 0;      ///< inside charts, drawn by chance, besides all at seams; 0 for all
    int repeats = 1;          ///< the median time counts
};

/// A line of the table.
struct BakeRow {
    std::string mesh;
    std::size_t triangles = 0;
    BakeMethodName method = BakeMethodName::Rays;
    int samples = 0;
    int mapSize = 0;        ///< texels
    double processor = 0.0; ///< seconds of all cores together
    double seconds = 0.0;   ///< of a whole bake: buffers, maps, padding; not of building ray trees
    MapErrors errors;
};

/// What a run that was stopped has left, and what keeps this one.
struct BakeMemory {
    std::vector<BakeRow> known;                                 ///< are not measured again
    std::function<void(const std::vector<BakeRow>& rows)> keep; ///< hears each new row
    std::filesystem::path truths; ///< folder that keeps truths, empty for none
};

/// A baker as the table's methods are. @param samples  rays, or directions.
Result<std::unique_ptr<bake::AbstractBaker>> bakerOf(const BakeMesh& mesh, BakeMethodName method,
                                                     int samples, const ProcAddressLoader& loader);

/// Measures a plan, in the current context. @param tell  hears what comes next, and the rows so
/// far; false ends the run, with the rows that there are.
Result<std::vector<BakeRow>>
runBakePlan(const BakePlan& plan, const BakeMemory& memory, const ProcAddressLoader& loader,
            const std::function<bool(const std::string& next, double done)>& tell);

} // namespace aolib::bench
