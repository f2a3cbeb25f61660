#include "bake/ShadowBaker.h"

#include <algorithm>
#include <new>
#include <string>
#include <utility>

#include <glm/geometric.hpp>

#include "bake/CheckOptions.h"
#include "bake/MapFill.h"
#include "bake/TexelRaster.h"
#include "bake/VertexWeld.h"
#include "gl/StateGuard.h"

namespace aolib::bake {

namespace {

/// Columns of the grid that vertices are put into.
constexpr int vertexColumns = 1024;

} // namespace

Result<BakeVertices> ShadowBaker::upload(int width, int height) const {
    const gl::StateGuard guard(*gpu_.gl);
    return BakeVertices::create(*gpu_.gl, gpu_.geometry, gpu_.frame, width, height);
}

Result<std::vector<glm::vec4>> ShadowBaker::sumsAt(Receivers receivers, const glm::ivec2& size,
                                                   const BakeVertices& vertices,
                                                   const BakeProgress& progress) const {
    const gl::Functions& gl = *gpu_.gl;
    ShadowPasses passes;
    {
        const gl::StateGuard guard(gl);
        ShadowPasses::Settings settings;
        settings.size = size;
        settings.depthSize = std::min(options_.depthSize, gl.capabilities.maxTextureSize);
        settings.mapsPerPass = options_.mapsPerPass;
        settings.bias = options_.bias;
        settings.ground = gpu_.ground();
        Result<ShadowPasses> made = ShadowPasses::create(gl, settings, gpu_.frame, receivers);
        if (!made) {
            return made.status();
        }
        passes = std::move(*made);
    }
    for (int first = 0; first < options_.directions; first += passes.mapsPerPass()) {
        if (progress && !progress(double(first) / double(options_.directions))) {
            return Status(StatusCode::Cancelled, "the bake was cancelled");
        }
        const gl::StateGuard guard(gl);
        std::vector<LightView> views;
        const int last = std::min(first + passes.mapsPerPass(), options_.directions);
        for (int i = first; i < last; ++i) {
            const auto index = static_cast<std::uint32_t>(i);
            const glm::dvec3 direction =
                lightDirection(options_.sky, gpu_.geometry.up(), options_.seed, index);
            views.push_back(
                lightView(gpu_.frame, direction, options_.depthSize, options_.seed, index));
        }
        passes.addDirections(vertices, views);
        gl.Finish();
    }
    const gl::StateGuard guard(gl);
    return passes.sums();
}

Result<std::vector<BakedMap>> ShadowBaker::bakeMaps(const MapOptions& options,
                                                    const BakeProgress& progress) try {
    if (Status status = check(options); !status) {
        return status;
    }
    const Result<BakeVertices> vertices = upload(options.width, options.height);
    if (!vertices) {
        return vertices.status();
    }
    const int count = gpu_.geometry.scene().mapCount();
    const double norm = cosineNorm(options_.sky, options_.directions);
    std::vector<BakedMap> maps;
    bool covered = false;
    for (int number = 0; number < count; ++number) {
        const TexelRaster raster(gpu_.geometry.scene(), number, options.width, options.height);
        covered = covered || raster.coveredTexels() > 0;
        std::vector<std::optional<SurfacePoint>> receivers(raster.size());
        for (std::size_t i = 0; i < raster.size(); ++i) {
            if (raster.kind(i) != TexelKind::Empty) {
                const glm::vec2& b = raster.barycentric(i);
                receivers[i] = gpu_.geometry.point(raster.triangle(i), double{b.x}, double{b.y});
            }
        }
        const auto share = [&](double fraction) {
            return !progress || progress((number + fraction) / count);
        };
        const auto sums = sumsAt(receivers, {options.width, options.height}, *vertices, share);
        if (!sums) {
            return sums.status();
        }
        BakedMap& map = maps.emplace_back(emptyMap(raster));
        for (std::size_t i = 0; i < receivers.size(); ++i) {
            if (receivers[i]) {
                setTexel(map, i, (*sums)[i], norm, receivers[i]->normal);
                map.visibility[i] = std::min(map.visibility[i], 1.0F);
            }
        }
        finish(map, options);
    }
    if (!covered) {
        return Status(StatusCode::InvalidPosition, "no triangle has UVs that cover a texel");
    }
    if (progress) {
        progress(1.0);
    }
    return maps;
} catch (const std::bad_alloc&) {
    return Status(StatusCode::OutOfMemory, "no memory left for maps of " +
                                               std::to_string(options.width) + " x " +
                                               std::to_string(options.height) + " texels");
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
    const Result<BakeVertices> vertices = upload(1, 1);
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
    std::vector<BakedVertices> result;
    for (const std::vector<std::uint32_t>& numbers : weld.number) {
        BakedVertices& values = result.emplace_back();
        for (const std::uint32_t number : numbers) {
            const bool used = number != VertexWeld::unused;
            const glm::vec4 sum = used ? (*sums)[number] : glm::vec4(0.0F);
            const float length = glm::length(glm::vec3(sum));
            const glm::dvec3 normal = used ? weld.points[number].normal : gpu_.geometry.up();
            values.visibility.push_back(
                used ? static_cast<float>(std::clamp(double{sum.w} * norm, 0.0, 1.0)) : 1.0F);
            values.bentNormal.push_back(length > 0.0F ? glm::vec3(sum) / length
                                                      : glm::vec3(normal));
        }
    }
    if (progress) {
        progress(1.0);
    }
    return result;
} catch (const std::bad_alloc&) {
    return Status(StatusCode::OutOfMemory, "no memory left for the values of vertices");
}

Result<std::unique_ptr<AbstractBaker>> createShadowBaker(const ProcAddressLoader& loader,
                                                         BakeScene scene,
                                                         const ShadowOptions& options) try {
    if (Status status = check(options); !status) {
        return status;
    }
    Result<GpuBake> gpu = GpuBake::create(loader, std::move(scene));
    if (!gpu) {
        return gpu.status();
    }
    return std::unique_ptr<AbstractBaker>(std::make_unique<ShadowBaker>(std::move(*gpu), options));
} catch (const std::bad_alloc&) {
    return Status(StatusCode::OutOfMemory, "no memory left for the scene to bake");
}

} // namespace aolib::bake
