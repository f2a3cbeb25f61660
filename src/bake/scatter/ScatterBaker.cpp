#include "bake/scatter/ScatterBaker.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <numeric>
#include <optional>
#include <span>

#include "bake/maps/CheckOptions.h"
#include "bake/maps/ProgressiveBake.h"
#include "bake/scatter/ScatterMaps.h"
#include "bake/scatter/ScatterPasses.h"
#include "bake/vertices/VertexFitting.h"
#include "bake/vertices/VertexWeld.h"
#include "gl/StateGuard.h"

namespace aolib::bake {

namespace {

/// Directions between two calls of the progress callback.
constexpr int viewsAtOnce = 4;
/// The picture, when its size is derived: pixels in what is a vertex's of the surface, on average,
/// where it faces the light.
constexpr double pixelsPerVertex = 16.0;
constexpr int leastVertexRaster = 512;
constexpr int largestVertexRaster = 4096;

int rasterSizeFor(const VertexSums& sums, int wanted, int most) {
    if (wanted > 0) {
        return std::min(wanted, most);
    }
    const double area = std::accumulate(sums.areas().begin(), sums.areas().end(), 0.0);
    const double vertices = static_cast<double>(sums.areas().size());
    const double size = double{ScatterPasses::pictureSide} *
                        std::sqrt(pixelsPerVertex * vertices / std::max(area, 1e-12));
    const int rounded =
        static_cast<int>(std::min(size, double{largestVertexRaster}) + 63.0) / 64 * 64;
    return std::clamp(rounded, leastVertexRaster, std::min(largestVertexRaster, most));
}

/// Of each vertex the mean over what is about it, nearer places counting more.
std::vector<glm::vec4> computeMeans(const VertexSums& sums, double norm) {
    std::vector<glm::vec4> values;
    values.reserve(sums.light().size());
    for (std::size_t i = 0; i < sums.light().size(); ++i) {
        const double area = sums.areas()[i];
        values.emplace_back(area > 0.0 ? sums.light()[i] * (norm / area) : glm::dvec4(0.0));
    }
    return values;
}

} // namespace

Result<std::vector<BakedMap>> ScatterBaker::bakeMaps(const MapOptions& options,
                                                     const BakeProgress& progress,
                                                     const SnapshotCallback& onSnapshot) try {
    if (AoStatus status = check(options); !status) {
        return status;
    }
    const gl::ContextScope scope(*gpu_.contexts);
    if (!scope.status()) {
        return scope.status();
    }
    ScatterMaps bake(gpu_, options_, options);
    if (AoStatus status = bake.run(progress, onSnapshot); !status) {
        return status;
    }
    Result<std::vector<BakedMap>> maps = bake.maps();
    if (maps && progress) {
        progress(1.0);
    }
    return maps;
} catch (const std::bad_alloc&) {
    return noMemoryForMaps(options);
}

AoStatus ScatterBaker::sumVertices(VertexSums& sums, const BakeProgress& progress) const {
    // No map decides which triangles are drawn with what: a map of one texel will do.
    const Result<BakeVertices> vertices = gpu_.upload(1, 1, nullptr);
    if (!vertices) {
        return vertices.status();
    }
    ScatterPasses::Settings settings;
    settings.rasterSize =
        rasterSizeFor(sums, options_.rasterSize, gpu_.gl->capabilities.maxTextureSize);
    settings.draws = false;
    settings.places = true;
    settings.slabs = !gpu_.reach.endless();
    std::optional<ScatterPasses> passes;
    {
        const gl::StateGuard guard(*gpu_.gl);
        Result<ScatterPasses> made = ScatterPasses::create(*gpu_.gl, settings, *vertices, {});
        if (!made) {
            return made.status();
        }
        passes = std::move(*made);
    }
    DirectionPlan plan;
    plan.last = options_.directions;
    plan.atOnce = viewsAtOnce;
    plan.pictureSize = settings.rasterSize;
    plan.sky = options_.sky;
    plan.seed = options_.seed;
    const auto add = [&](std::span<const LightView> views) {
        AoStatus status;
        for (std::size_t i = 0; i < views.size() && status; ++i) {
            status =
                passes->drawSurface(views[i], [&] { sums.add(passes->readSurface(), views[i]); });
        }
        return status;
    };
    return gpu_.addDirections(plan, progress, add).status();
}

Result<std::vector<BakedVertices>> ScatterBaker::bakeVertices(const VertexOptions& options,
                                                              const BakeProgress& progress) try {
    if (AoStatus status = check(options); !status) {
        return status;
    }
    if (options.fit == VertexFit::TriangleMean) {
        return AoStatus(
            StatusCode::MissingCapability,
            "scattered points lie all over the triangles: VertexFit::Direct takes their "
            "mean about each vertex, LeastSquares fits them");
    }
    const gl::ContextScope scope(*gpu_.contexts);
    if (!scope.status()) {
        return scope.status();
    }
    const VertexWeld weld = weldVertices(gpu_.geometry);
    VertexSums sums(gpu_.geometry, gpu_.frame, weld, gpu_.ground());
    if (AoStatus status = sumVertices(sums, progress); !status) {
        return status;
    }
    const double norm = cosineNorm(options_.sky, options_.directions);
    std::vector<glm::vec4> values = computeMeans(sums, norm);
    if (options.fit == VertexFit::LeastSquares) {
        std::vector<glm::dvec4> integrals = sums.light();
        for (glm::dvec4& integral : integrals) {
            integral *= norm / (gpu_.frame.scale() * gpu_.frame.scale());
        }
        values = fitIntegrals(gpu_.geometry, weld, integrals, values, double{options.smoothness});
    }
    if (progress) {
        progress(1.0);
    }
    return unweldedVertices(gpu_.geometry, weld, values);
} catch (const std::bad_alloc&) {
    return AoStatus(StatusCode::OutOfMemory, "no memory left for the values of vertices");
}

Result<BakedMap> ScatterBaker::bakeView(const ViewPixels& /*view*/,
                                        const BakeProgress& /*progress*/) {
    return AoStatus(StatusCode::MissingCapability,
                    "points are scattered into maps and among vertices, which are the model's own: "
                    "rays and shadow maps ask from a view's pixels");
}

Result<std::unique_ptr<AbstractBaker>> createScatterBaker(const ProcAddressLoader& loader,
                                                          BakeScene scene,
                                                          const ScatterOptions& options) {
    return createGpuBaker<ScatterBaker>(loader, std::move(scene), options);
}

} // namespace aolib::bake
