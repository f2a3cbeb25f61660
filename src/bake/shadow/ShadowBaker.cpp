#include "bake/shadow/ShadowBaker.h"

#include <algorithm>
#include <new>
#include <string>
#include <type_traits>
#include <utility>

#include <glm/geometric.hpp>

#include "bake/maps/CheckOptions.h"
#include "bake/maps/ProgressiveBake.h"
#include "bake/maps/ViewReceivers.h"
#include "bake/shadow/ShadowPasses.h"
#include "bake/shadow/SlabPasses.h"
#include "bake/vertices/VertexFitting.h"
#include "bake/vertices/VertexWeld.h"
#include "gl/StateGuard.h"

namespace aolib::bake {

namespace {

/// Columns of the grid that vertices are put into, where they fit.
constexpr int leastColumns = 1024;

} // namespace

/// Room for sums of a grid of receivers, and for depth maps.
Result<ShadowBaker::Work> ShadowBaker::workFor(const BakeVertices& vertices,
                                               const glm::ivec2& size) const {
    const gl::StateGuard guard(*gpu_.gl);
    DepthSettings settings;
    settings.size = std::min(options_.depthSize, gpu_.gl->capabilities.maxTextureSize);
    settings.mapsPerPass = options_.mapsPerPass;
    settings.bias = options_.bias;
    settings.ground = gpu_.ground();
    Work work;
    work.depthSize = settings.size;
    AoStatus status;
    const auto keep = [&](auto passes) {
        status = passes.status();
        if (passes) {
            work.passes = std::make_unique<std::decay_t<decltype(*passes)>>(std::move(*passes));
        }
    };
    if (gpu_.reach.endless()) {
        keep(ShadowPasses::create(*gpu_.gl, settings, vertices));
    } else {
        keep(SlabPasses::create(*gpu_.gl, settings, vertices));
    }
    if (!status) {
        return status;
    }
    Result<ReceiverSums> sums = ReceiverSums::create(*gpu_.gl, size);
    if (!sums) {
        return sums.status();
    }
    work.sums = std::move(*sums);
    return work;
}

/// Sums up what some of the directions light at receivers.
Result<std::vector<glm::vec4>> ShadowBaker::computeSums(Work& work, Receivers receivers,
                                                        const SampleRange& directions,
                                                        const BakeProgress& progress) const {
    {
        const gl::StateGuard guard(*gpu_.gl);
        work.sums.begin(gpu_.frame, receivers);
    }
    // What pictures show: receivers, and where they are lifted to.
    FrameBox box = work.sums.box();
    box.half += double{options_.bias} * 2.0 * glm::length(box.half) / double(work.depthSize);
    DirectionPlan plan;
    plan.first = directions.first;
    plan.last = directions.last;
    plan.atOnce = work.passes->mapsPerPass();
    plan.pictureSize = work.depthSize;
    plan.box = box;
    plan.sky = options_.sky;
    plan.seed = options_.seed;
    const auto add = [&](std::span<const LightView> views) {
        return work.passes->addDirections(views, work.sums);
    };
    if (const Result<int> added = gpu_.addDirections(plan, progress, add); !added) {
        return added.status();
    }
    const gl::StateGuard guard(*gpu_.gl);
    return work.sums.sums();
}

Result<std::vector<BakedMap>> ShadowBaker::bakeMaps(const MapOptions& options,
                                                    const BakeProgress& progress,
                                                    const SnapshotCallback& onSnapshot) try {
    if (AoStatus status = check(options); !status) {
        return status;
    }
    const gl::ContextScope scope(*gpu_.contexts);
    if (!scope.status()) {
        return scope.status();
    }
    const Result<BakeVertices> vertices = gpu_.upload(options.width, options.height, nullptr);
    if (!vertices) {
        return vertices.status();
    }
    Result<Work> work = workFor(*vertices, {options.width, options.height});
    if (!work) {
        return work.status();
    }
    TexelMethod method;
    method.samples = options_.directions;
    method.least = work->passes->mapsPerPass();
    method.norm = [this](int directions) { return cosineNorm(options_.sky, directions); };
    method.add = [&](const SampleRange& directions, int /*number*/, MapSums& map,
                     const BakeProgress& share) {
        std::vector<std::optional<SurfacePoint>> points(map.light.size());
        for (std::size_t i = 0; i < points.size(); ++i) {
            points[i] = map.receivers.at(i);
        }
        const Result<std::vector<glm::vec4>> sums = computeSums(*work, points, directions, share);
        if (!sums) {
            return sums.status();
        }
        std::transform(sums->begin(), sums->end(), map.light.begin(), map.light.begin(),
                       [](const glm::vec4& a, const glm::vec4& b) { return a + b; });
        return AoStatus();
    };
    return bakeInPasses(gpu_.geometry, options, method, progress, onSnapshot);
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
        return AoStatus(StatusCode::MissingCapability,
                        std::to_string(points.size()) + " places are more than a texture holds");
    }
    if (points.empty()) {
        return std::vector<glm::vec4>();
    }
    std::vector<std::optional<SurfacePoint>> receivers(points.begin(), points.end());
    receivers.resize(rows * std::size_t(columns));
    Result<Work> work = workFor(*vertices, {columns, static_cast<int>(rows)});
    if (!work) {
        return work.status();
    }
    const Result<std::vector<glm::vec4>> sums =
        computeSums(*work, receivers, {0, options_.directions}, progress);
    if (!sums) {
        return sums.status();
    }
    const double norm = cosineNorm(options_.sky, options_.directions);
    std::vector<glm::vec4> values;
    for (const glm::vec4& sum : *sums) {
        values.emplace_back(static_cast<float>(double{sum.w} * norm), glm::vec3(sum));
    }
    values.resize(points.size());
    return values;
}

Result<std::vector<BakedVertices>> ShadowBaker::bakeVertices(const VertexOptions& options,
                                                             const BakeProgress& progress) try {
    if (AoStatus status = check(options); !status) {
        return status;
    }
    const gl::ContextScope scope(*gpu_.contexts);
    if (!scope.status()) {
        return scope.status();
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
    return AoStatus(StatusCode::OutOfMemory, "no memory left for the values of vertices");
}

Result<BakedMap> ShadowBaker::bakeView(const ViewPixels& view, const BakeProgress& progress) try {
    const Result<std::vector<SurfacePoint>> points = findReceivers(view);
    if (!points) {
        return points.status();
    }
    const gl::ContextScope scope(*gpu_.contexts);
    if (!scope.status()) {
        return scope.status();
    }
    const Result<std::vector<glm::vec4>> values = valuesAt(*points, progress);
    if (values && progress) {
        progress(1.0);
    }
    return values ? Result<BakedMap>(makePicture(view, *values)) : values.status();
} catch (const std::bad_alloc&) {
    return noMemoryForView();
}

Result<std::unique_ptr<AbstractBaker>>
createShadowBaker(const ProcAddressLoader& loader, BakeScene scene, const ShadowOptions& options) {
    return createGpuBaker<ShadowBaker>(loader, std::move(scene), options);
}

} // namespace aolib::bake
