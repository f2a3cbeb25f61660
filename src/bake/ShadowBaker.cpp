#include "bake/ShadowBaker.h"

#include <algorithm>
#include <limits>
#include <new>
#include <string>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "bake/CheckOptions.h"
#include "bake/MapLoop.h"
#include "bake/VertexFitting.h"
#include "bake/VertexWeld.h"
#include "bake/ViewReceivers.h"
#include "gl/StateGuard.h"

namespace aolib::bake {

namespace {

/// Columns of the grid that vertices are put into, where they fit.
constexpr int leastColumns = 1024;

/// The box about receivers, and about where they are lifted to.
/// @param texels  how far that is at most.
FrameBox boxOf(const BakeFrame& frame, std::span<const std::optional<SurfacePoint>> receivers,
               double texels, int depthSize) {
    glm::dvec3 low(std::numeric_limits<double>::infinity());
    glm::dvec3 high = -low;
    for (const std::optional<SurfacePoint>& receiver : receivers) {
        if (receiver) {
            const glm::dvec3 place(frame.toFrame(receiver->position));
            low = glm::min(low, place);
            high = glm::max(high, place);
        }
    }
    if (low.x > high.x) {
        return {};
    }
    const glm::dvec3 half = 0.5 * (high - low);
    const double texel = 2.0 * glm::length(half) / double(depthSize);
    return {0.5 * (low + high), half + texels * texel};
}

} // namespace

/// Room for sums of a grid of receivers.
Result<ShadowPasses> ShadowBaker::passesFor(const glm::ivec2& size) const {
    const gl::StateGuard guard(*gpu_.gl);
    ShadowPasses::Settings settings;
    settings.size = size;
    settings.depthSize = std::min(options_.depthSize, gpu_.gl->capabilities.maxTextureSize);
    settings.mapsPerPass = options_.mapsPerPass;
    settings.bias = options_.bias;
    settings.ground = gpu_.ground();
    return ShadowPasses::create(*gpu_.gl, settings);
}

/// Sums up what some of the directions light at receivers.
Status ShadowBaker::add(ShadowPasses& passes, const BakeVertices& vertices, Receivers receivers,
                        const SampleRange& directions, const BakeProgress& progress) const {
    {
        const gl::StateGuard guard(*gpu_.gl);
        passes.begin(gpu_.frame, receivers);
    }
    DirectionPlan plan;
    plan.first = directions.first;
    plan.last = directions.last;
    plan.atOnce = passes.mapsPerPass();
    plan.pictureSize = passes.depthSize();
    plan.box = boxOf(gpu_.frame, receivers, double{options_.bias}, passes.depthSize());
    plan.sky = options_.sky;
    plan.seed = options_.seed;
    const auto add = [&](std::span<const LightView> views) {
        passes.addDirections(vertices, views);
    };
    return gpu_.addDirections(plan, progress, add).status();
}

std::vector<glm::vec4> ShadowBaker::sumsOf(const ShadowPasses& passes) const {
    const gl::StateGuard guard(*gpu_.gl);
    return passes.sums();
}

Result<std::vector<BakedMap>> ShadowBaker::bakeMaps(const MapOptions& options,
                                                    const BakeProgress& progress,
                                                    const BakeWatch& watch) try {
    if (Status status = check(options); !status) {
        return status;
    }
    const Result<BakeVertices> vertices = gpu_.upload(options.width, options.height, nullptr);
    if (!vertices) {
        return vertices.status();
    }
    Result<ShadowPasses> passes = passesFor({options.width, options.height});
    if (!passes) {
        return passes.status();
    }
    TexelMethod method;
    method.samples = options_.directions;
    method.least = passes->mapsPerPass();
    method.norm = [this](int directions) { return cosineNorm(options_.sky, directions); };
    method.add = [&](const SampleRange& directions, int /*number*/, MapSums& map,
                     const BakeProgress& share) {
        std::vector<std::optional<SurfacePoint>> points(map.light.size());
        for (std::size_t i = 0; i < points.size(); ++i) {
            points[i] = map.receivers.at(i);
        }
        if (Status status = add(*passes, *vertices, points, directions, share); !status) {
            return status;
        }
        const std::vector<glm::vec4> sums = sumsOf(*passes);
        std::transform(sums.begin(), sums.end(), map.light.begin(), map.light.begin(),
                       [](const glm::vec4& a, const glm::vec4& b) { return a + b; });
        return Status();
    };
    return bakeInPasses(gpu_.geometry, options, method, progress, watch);
} catch (const std::bad_alloc&) {
    return noMemoryForMaps(options);
}

/// W and the weighed direction at places.
Result<std::vector<glm::vec4>> ShadowBaker::valuesAt(const std::vector<SurfacePoint>& points,
                                                     const BakeProgress& progress) const {
    const Result<BakeVertices> vertices = gpu_.upload(1, 1, nullptr);
    if (!vertices) {
        return vertices.status();
    }
    const int most = gpu_.gl->capabilities.maxTextureSize;
    const int columns =
        points.size() <= std::size_t(leastColumns) * std::size_t(most) ? leastColumns : most;
    const auto rows = (points.size() + std::size_t(columns) - 1) / std::size_t(columns);
    if (rows > std::size_t(most)) {
        return Status(StatusCode::MissingCapability,
                      std::to_string(points.size()) + " places are more than a texture holds");
    }
    if (points.empty()) {
        return std::vector<glm::vec4>();
    }
    std::vector<std::optional<SurfacePoint>> receivers(points.begin(), points.end());
    receivers.resize(rows * std::size_t(columns));
    Result<ShadowPasses> passes = passesFor({columns, static_cast<int>(rows)});
    if (!passes) {
        return passes.status();
    }
    if (Status status = add(*passes, *vertices, receivers, {0, options_.directions}, progress);
        !status) {
        return status;
    }
    const double norm = cosineNorm(options_.sky, options_.directions);
    std::vector<glm::vec4> values;
    for (const glm::vec4& sum : sumsOf(*passes)) {
        values.emplace_back(static_cast<float>(double{sum.w} * norm), glm::vec3(sum));
    }
    values.resize(points.size());
    return values;
}

Result<std::vector<BakedVertices>> ShadowBaker::bakeVertices(const VertexOptions& options,
                                                             const BakeProgress& progress) try {
    if (Status status = check(options); !status) {
        return status;
    }
    const auto trace = [&](const std::vector<SurfacePoint>& points) {
        return valuesAt(points, progress);
    };
    const VertexWeld weld = weldVertices(gpu_.geometry);
    const Result<std::vector<glm::vec4>> values = weldedValues(gpu_.geometry, weld, options, trace);
    if (!values) {
        return values.status();
    }
    if (progress) {
        progress(1.0);
    }
    return unweldedVertices(gpu_.geometry, weld, *values);
} catch (const std::bad_alloc&) {
    return Status(StatusCode::OutOfMemory, "no memory left for the values of vertices");
}

Result<BakedMap> ShadowBaker::bakeView(const ViewPixels& view, const BakeProgress& progress) try {
    const Result<std::vector<SurfacePoint>> points = receiversOf(view);
    if (!points) {
        return points.status();
    }
    const Result<std::vector<glm::vec4>> values = valuesAt(*points, progress);
    if (values && progress) {
        progress(1.0);
    }
    return values ? Result<BakedMap>(pictureOf(view, *values)) : values.status();
} catch (const std::bad_alloc&) {
    return noMemoryForView();
}

Result<std::unique_ptr<AbstractBaker>>
createShadowBaker(const ProcAddressLoader& loader, BakeScene scene, const ShadowOptions& options) {
    return createGpuBaker<ShadowBaker>(loader, std::move(scene), options);
}

} // namespace aolib::bake
