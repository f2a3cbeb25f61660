#include "bake/ShadowBaker.h"

#include <algorithm>
#include <new>
#include <utility>

#include "bake/CheckOptions.h"
#include "bake/MapLoop.h"
#include "bake/VertexWeld.h"
#include "gl/StateGuard.h"

namespace aolib::bake {

namespace {

/// Columns of the grid that vertices are put into.
constexpr int vertexColumns = 1024;

} // namespace

Result<std::vector<glm::vec4>> ShadowBaker::sumsAt(Receivers receivers, const glm::ivec2& size,
                                                   const BakeVertices& vertices,
                                                   const BakeProgress& progress) const {
    const gl::Functions& gl = *gpu_.gl;
    DirectionPlan plan;
    plan.directions = options_.directions;
    plan.pictureSize = std::min(options_.depthSize, gl.capabilities.maxTextureSize);
    plan.sky = options_.sky;
    plan.seed = options_.seed;
    ShadowPasses passes;
    {
        const gl::StateGuard guard(gl);
        ShadowPasses::Settings settings;
        settings.size = size;
        settings.depthSize = plan.pictureSize;
        settings.mapsPerPass = options_.mapsPerPass;
        settings.bias = options_.bias;
        settings.ground = gpu_.ground();
        Result<ShadowPasses> made = ShadowPasses::create(gl, settings, gpu_.frame, receivers);
        if (!made) {
            return made.status();
        }
        passes = std::move(*made);
    }
    plan.atOnce = passes.mapsPerPass();
    const auto add = [&](std::span<const LightView> views) {
        passes.addDirections(vertices, views);
    };
    if (Status status = gpu_.addDirections(plan, progress, add); !status) {
        return status;
    }
    const gl::StateGuard guard(gl);
    return passes.sums();
}

Status ShadowBaker::bakeMap(const TexelRaster& raster, const BakeVertices& vertices, BakedMap& map,
                            const BakeProgress& progress) const {
    std::vector<std::optional<SurfacePoint>> receivers(raster.size());
    for (std::size_t i = 0; i < raster.size(); ++i) {
        if (raster.kind(i) != TexelKind::Empty) {
            const glm::vec2& b = raster.barycentric(i);
            receivers[i] = gpu_.geometry.point(raster.triangle(i), double{b.x}, double{b.y});
        }
    }
    const auto sums = sumsAt(receivers, {raster.width(), raster.height()}, vertices, progress);
    if (!sums) {
        return sums.status();
    }
    const double norm = cosineNorm(options_.sky, options_.directions);
    for (std::size_t i = 0; i < receivers.size(); ++i) {
        if (receivers[i]) {
            setTexel(map, i, (*sums)[i], norm, receivers[i]->normal);
            map.visibility[i] = std::min(map.visibility[i], 1.0F);
        }
    }
    return {};
}

Result<std::vector<BakedMap>> ShadowBaker::bakeMaps(const MapOptions& options,
                                                    const BakeProgress& progress) try {
    if (Status status = check(options); !status) {
        return status;
    }
    const Result<BakeVertices> vertices = gpu_.upload(options.width, options.height);
    if (!vertices) {
        return vertices.status();
    }
    const auto bake = [&](const TexelRaster& raster, int /*number*/, BakedMap& map,
                          const BakeProgress& share) {
        return bakeMap(raster, *vertices, map, share);
    };
    return bakeEachMap(gpu_.geometry.scene(), options, progress, bake);
} catch (const std::bad_alloc&) {
    return noMemoryForMaps(options);
}

Result<std::vector<BakedVertices>> ShadowBaker::bakeVertices(const VertexOptions& options,
                                                             const BakeProgress& progress) try {
    if (Status status = check(options); !status) {
        return status;
    }
    if (options.fit != VertexFit::Direct) {
        return Status(StatusCode::MissingCapability,
                      "shadow maps are read at the vertices alone; rays fit the surface");
    }
    const Result<BakeVertices> vertices = gpu_.upload(1, 1);
    if (!vertices) {
        return vertices.status();
    }
    const VertexWeld weld = weldVertices(gpu_.geometry);
    const int rows = static_cast<int>((weld.points.size() + vertexColumns - 1) / vertexColumns);
    std::vector<std::optional<SurfacePoint>> receivers(weld.points.begin(), weld.points.end());
    receivers.resize(static_cast<std::size_t>(rows) * vertexColumns);
    const auto sums = sumsAt(receivers, {vertexColumns, rows}, *vertices, progress);
    if (!sums) {
        return sums.status();
    }
    const double norm = cosineNorm(options_.sky, options_.directions);
    std::vector<glm::vec4> values;
    for (const glm::vec4& sum : *sums) {
        values.emplace_back(static_cast<float>(double{sum.w} * norm), glm::vec3(sum));
    }
    if (progress) {
        progress(1.0);
    }
    return unweldedVertices(gpu_.geometry, weld, values);
} catch (const std::bad_alloc&) {
    return Status(StatusCode::OutOfMemory, "no memory left for the values of vertices");
}

Result<std::unique_ptr<AbstractBaker>>
createShadowBaker(const ProcAddressLoader& loader, BakeScene scene, const ShadowOptions& options) {
    return createGpuBaker<ShadowBaker>(loader, std::move(scene), options);
}

} // namespace aolib::bake
