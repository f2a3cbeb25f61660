#include "bake/rays/RayBaker.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <new>
#include <utility>

#include <glm/geometric.hpp>

#include "bake/maps/CheckOptions.h"
#include "bake/maps/ProgressiveBake.h"
#include "bake/maps/ViewReceivers.h"
#include "bake/vertices/VertexFitting.h"
#include "parallel/ParallelLoop.h"

namespace aolib::bake {

namespace {

/// Texels along a tile's edge: a tile is a group of receivers.
constexpr int tileSide = 4;
static_assert(tileSide * tileSide == int{ReceiverTracer::capacity});

/// Kinds of receivers draw their rays from sequences of their own.
constexpr int vertexKind = 8191;

/// The open share of each sector, W where no ray went.
OpenSectors computeOpenShares(const HemisphereSample& sample, float visibility) {
    OpenSectors shares{};
    for (std::size_t k = 0; k < shares.size(); ++k) {
        shares[k] = sample.all[k] > 0.0F ? sample.open[k] / sample.all[k] : visibility;
    }
    return shares;
}

glm::vec3 unitOr(const glm::vec3& v, const glm::dvec3& fallback) {
    const float length = glm::length(v);
    return length > 0.0F ? v / length : glm::vec3(fallback);
}

} // namespace

SequenceSeed RayBaker::makeSeed(int kind, std::size_t a, std::size_t b) const {
    const SequenceSeed own = sequenceSeed(kind, static_cast<int>(a), static_cast<int>(b));
    const SequenceSeed user = sequenceSeed(0, 0, static_cast<int>(options_.seed & 0x7fffffffU));
    return options_.seed == 0 ? own
                              : SequenceSeed{own.first ^ user.first, own.second ^ user.second};
}

bool RayBaker::traceGroups(std::size_t groups, const SampleRange& rays, const FillGroup& fill,
                           const TakeResult& take, const BakeProgress& progress) const {
    const auto body = [&](std::size_t begin, std::size_t end) {
        const auto tracer = std::make_unique<ReceiverTracer>(geometry_, rays_, options_);
        std::array<Receiver, ReceiverTracer::capacity> receivers;
        std::array<HemisphereSample, ReceiverTracer::capacity> found;
        for (std::size_t group = begin; group < end; ++group) {
            const std::size_t count = fill(group, receivers.data());
            if (count == 0) {
                continue;
            }
            tracer->trace(std::span(receivers).first(count), rays.first, rays.last,
                          std::span(found).first(count));
            for (std::size_t i = 0; i < count; ++i) {
                take(receivers[i], found[i]);
            }
        }
    };
    return parallelLoop(groups, options_.threads, body, progress);
}

/// Adds what some of the rays find to a map's sums.
AoStatus RayBaker::addRays(const SampleRange& rays, int number, MapSums& map,
                           const BakeProgress& progress) const {
    const int width = map.receivers.raster().width();
    const int height = map.receivers.raster().height();
    const int across = (width + tileSide - 1) / tileSide;
    const int along = (height + tileSide - 1) / tileSide;
    const auto fill = [&](std::size_t tile, Receiver* receivers) {
        std::size_t count = 0;
        const int left = static_cast<int>(tile % static_cast<std::size_t>(across)) * tileSide;
        const int bottom = static_cast<int>(tile / static_cast<std::size_t>(across)) * tileSide;
        for (int y = bottom; y < std::min(bottom + tileSide, height); ++y) {
            for (int x = left; x < std::min(left + tileSide, width); ++x) {
                const auto texel = static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                   static_cast<std::size_t>(x);
                if (const auto point = map.receivers.at(texel)) {
                    receivers[count++] = {
                        *point,
                        makeSeed(number, static_cast<std::size_t>(x), static_cast<std::size_t>(y)),
                        texel};
                }
            }
        }
        return count;
    };
    const auto take = [&](const Receiver& receiver, const HemisphereSample& sample) {
        map.light[receiver.place] += glm::vec4(sample.direction, sample.visibility);
    };
    const bool done =
        traceGroups(static_cast<std::size_t>(across) * static_cast<std::size_t>(along), rays, fill,
                    take, progress);
    return done ? AoStatus() : cancelledBake();
}

Result<std::vector<BakedMap>> RayBaker::bakeMaps(const MapOptions& options,
                                                 const BakeProgress& progress,
                                                 const SnapshotCallback& onSnapshot) {
    TexelMethod method;
    method.samples = options_.rays;
    method.norm = [](int rays) { return 1.0 / rays; };
    method.add = [this](const SampleRange& rays, int number, MapSums& map,
                        const BakeProgress& share) { return addRays(rays, number, map, share); };
    return bakeInPasses(geometry_, options, method, progress, onSnapshot);
}

Result<std::vector<glm::vec4>> RayBaker::tracePoints(const std::vector<SurfacePoint>& points,
                                                     std::vector<OpenSectors>* sectors,
                                                     const BakeProgress& progress) const {
    constexpr std::size_t size = ReceiverTracer::capacity;
    std::vector<glm::vec4> values(points.size());
    if (sectors != nullptr) {
        sectors->resize(points.size());
    }
    const auto fill = [&](std::size_t group, Receiver* receivers) {
        const std::size_t end = std::min(points.size(), (group + 1) * size);
        for (std::size_t i = group * size; i < end; ++i) {
            receivers[i - group * size] = {points[i], makeSeed(vertexKind, i >> 20U, i & 0xfffffU),
                                           i};
        }
        return end - group * size;
    };
    const auto take = [&](const Receiver& receiver, const HemisphereSample& sample) {
        const float visibility = sample.visibility / float(options_.rays);
        values[receiver.place] = {visibility, unitOr(sample.direction, receiver.point.normal)};
        if (sectors != nullptr) {
            (*sectors)[receiver.place] = computeOpenShares(sample, visibility);
        }
    };
    if (!traceGroups((points.size() + size - 1) / size, {0, options_.rays}, fill, take, progress)) {
        return cancelledBake();
    }
    return values;
}

Result<std::vector<BakedVertices>> RayBaker::bakeVertices(const VertexOptions& options,
                                                          const BakeProgress& progress) try {
    if (AoStatus status = check(options); !status) {
        return status;
    }
    if (options_.sectors && options.fit != VertexFit::Direct) {
        return AoStatus(StatusCode::MissingCapability,
                        "sectors are traced at the vertices alone: VertexFit::Direct");
    }
    const VertexWeld weld = weldVertices(geometry_);
    std::vector<OpenSectors> sectors;
    const auto trace = [&](const std::vector<SurfacePoint>& points) {
        return tracePoints(points, options_.sectors ? &sectors : nullptr, progress);
    };
    const Result<std::vector<glm::vec4>> values = weldedValues(geometry_, weld, options, trace);
    if (!values) {
        return values.status();
    }
    return unweldedVertices(geometry_, weld, *values, sectors);
} catch (const std::bad_alloc&) {
    return AoStatus(StatusCode::OutOfMemory, "no memory left for the values of vertices");
}

Result<BakedMap> RayBaker::bakeView(const ViewPixels& view, const BakeProgress& progress) try {
    const Result<std::vector<SurfacePoint>> points = findReceivers(view);
    if (!points) {
        return points.status();
    }
    const Result<std::vector<glm::vec4>> values = tracePoints(*points, nullptr, progress);
    return values ? Result<BakedMap>(makePicture(view, *values)) : values.status();
} catch (const std::bad_alloc&) {
    return noMemoryForView();
}

Result<std::unique_ptr<AbstractBaker>> createRayBaker(BakeScene scene,
                                                      const RayOptions& options) try {
    if (AoStatus status = check(options); !status) {
        return status;
    }
    Result<BakeGeometry> geometry = BakeGeometry::create(std::move(scene));
    if (!geometry) {
        return geometry.status();
    }
    Result<RayScene> rays = RayScene::create(geometry->occluders());
    if (!rays) {
        return rays.status();
    }
    return std::unique_ptr<AbstractBaker>(
        std::make_unique<RayBaker>(std::move(*geometry), std::move(*rays), options));
} catch (const std::bad_alloc&) {
    return AoStatus(StatusCode::OutOfMemory, "no memory left for the scene to bake");
}

} // namespace aolib::bake
