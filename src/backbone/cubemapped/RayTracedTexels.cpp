#include "backbone/cubemapped/RayTracedTexels.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <glm/geometric.hpp>

#include "backbone/cubemapped/FaceCapture.h"
#include "shared/cube_faces.h"
#include "shared/distance_code.h"

namespace aolib {

namespace {

/// Rays of the first pass, after which a cube map is shown, and after the second; from then on each
/// pass doubles them. Their RMSE is about 0.03 and 0.01.
constexpr int kFirstRays = 16;
constexpr int kSecondRays = 64;
/// Tiles queued at a time: enough to keep workers busy between frames.
constexpr std::size_t kQueue = 512;
/// Results that are taken before the clock is looked at again.
constexpr std::size_t kAtATime = 4;

// A request's key: cube map, tile and generation.
constexpr unsigned kTileBits = 24;
constexpr unsigned kGenerationBits = 16;

std::uint64_t keyOf(CubeMapId id, int tile, std::uint32_t generation) {
    return (static_cast<std::uint64_t>(id) << (kTileBits + kGenerationBits)) |
           (static_cast<std::uint64_t>(tile) << kGenerationBits) |
           (generation & ((1U << kGenerationBits) - 1U));
}

} // namespace

int RayTracedTexels::raysAfter(int passes) const {
    const int most = context_.options.rayTraced.rays;
    int rays = passes == 0 ? 0 : passes == 1 ? kFirstRays : kSecondRays;
    for (int pass = 2; pass < passes && rays < most; ++pass) {
        rays *= 2;
    }
    return std::min(rays, most);
}

int RayTracedTexels::passes() const {
    int count = 1;
    while (raysAfter(count) < context_.options.rayTraced.rays) {
        ++count;
    }
    return count;
}

void RayTracedTexels::sceneChanged() {
    std::vector<glm::vec3> positions;
    std::vector<std::uint32_t> indices;
    for (const auto& [id, mesh] : context_.scene.meshes()) {
        const auto first = static_cast<std::uint32_t>(positions.size());
        const glm::dmat4 transform(mesh.transform);
        for (const glm::vec3& position : mesh.positions) {
            positions.emplace_back(glm::dvec3(transform * glm::dvec4(position, 1.0)));
        }
        for (const std::uint32_t index : mesh.indices) {
            indices.push_back(first + index);
        }
    }
    tracer_.setScene(std::move(positions), std::move(indices));
    for (auto& [id, work] : works_) {
        work.generation = ++generations_; // what was queued is lost
    }
    askedBefore_ = 0;
}

RayTracedTexels::Work& RayTracedTexels::workOf(CubeMapId id) {
    const auto [found, isNew] = works_.try_emplace(id);
    if (isNew) {
        found->second.generation = ++generations_;
    }
    return found->second;
}

void RayTracedTexels::forget(CubeMapId id) {
    works_.erase(id);
    askedBefore_ = 0;
}

Status RayTracedTexels::complete(CubeMapProjector& projector) {
    projector.tiles.askAll();
    const std::vector<CubeMapProjector*> one{&projector};
    while (projector.tiles.lacks(passes())) {
        request(one);
        tracer_.wait(1000.0);
        if (Status status = takeResults(one, HUGE_VAL); !status) {
            return status;
        }
    }
    projector.shown = true;
    return {};
}

Status RayTracedTexels::advance(const std::vector<CubeMapProjector*>& projectors,
                                double milliseconds) {
    if (Status status = takeResults(projectors, milliseconds); !status) {
        return status;
    }
    request(projectors);
    for (CubeMapProjector* projector : projectors) {
        projector->shown = projector->shown || projector->tiles.fewestPasses() >= 1;
    }
    return {};
}

void RayTracedTexels::request(const std::vector<CubeMapProjector*>& projectors) {
    struct Wanted {
        int passes;
        CubeMapProjector* projector;
        int tile;
    };
    std::vector<Wanted> wanted;
    int asked = 0;
    for (CubeMapProjector* projector : projectors) {
        for (int tile = 0; tile < projector->tiles.count(); ++tile) {
            const bool isAsked = projector->tiles.asked(tile);
            asked += isAsked ? 1 : 0;
            if (isAsked && projector->tiles.passes(tile) < passes()) {
                wanted.push_back({projector->tiles.passes(tile), projector, tile});
            }
        }
    }
    // What a worker has begun would be begun again: the queue is only exchanged when it runs low or
    // something new is asked for.
    const bool low = tracer_.pending() <= queued_ / 4;
    if (wanted.empty() || (asked == askedBefore_ && !low)) {
        return;
    }
    askedBefore_ = asked;
    std::stable_sort(wanted.begin(), wanted.end(),
                     [](const Wanted& a, const Wanted& b) { return a.passes < b.passes; });
    wanted.resize(std::min(wanted.size(), kQueue));
    std::vector<TexelRequest> queue;
    for (const Wanted& one : wanted) {
        const TileProgress::Region region = one.projector->tiles.region(one.tile);
        const int before = raysAfter(one.passes);
        queue.push_back(
            {.key = keyOf(one.projector->id(), one.tile, workOf(one.projector->id()).generation),
             .centre = one.projector->position(),
             .faceSize = one.projector->tiles.faceSize(),
             .face = region.face,
             .x = region.x,
             .y = region.y,
             .width = region.width,
             .height = region.height,
             .firstRay = before,
             .rays = raysAfter(one.passes + 1) - before,
             .radius = radius_,
             .falloff = context_.options.falloff});
    }
    queued_ = queue.size();
    tracer_.request(std::move(queue));
}

Status RayTracedTexels::takeResults(const std::vector<CubeMapProjector*>& projectors,
                                    double milliseconds) {
    const auto start = std::chrono::steady_clock::now();
    double spent = 0.0;
    for (auto results = tracer_.take(kAtATime); !results.empty();
         results = tracer_.take(kAtATime)) {
        for (const TracedTexels& traced : results) {
            const std::uint64_t key = traced.request.key;
            const auto found =
                std::find_if(projectors.begin(), projectors.end(), [&](const auto* projector) {
                    return keyOf(projector->id(), 0, 0) >> (kTileBits + kGenerationBits) ==
                           key >> (kTileBits + kGenerationBits);
                });
            if (found == projectors.end()) {
                continue; // gone, or too far away meanwhile; it is asked for again when it is back
            }
            const auto tile =
                static_cast<int>((key >> kGenerationBits) & ((1ULL << kTileBits) - 1ULL));
            if (keyOf((*found)->id(), tile, workOf((*found)->id()).generation) != key) {
                continue;
            }
            if (Status status = take(**found, traced, tile); !status) {
                return status;
            }
        }
        spent = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
                    .count();
        if (spent >= milliseconds) {
            break;
        }
    }
    return tracer_.status();
}

Status RayTracedTexels::take(CubeMapProjector& projector, const TracedTexels& traced, int tile) {
    Tile& sums = workOf(projector.id()).tiles[tile];
    if (sums.sum.empty()) {
        sums.sum.resize(traced.visibility.size(), 0.0F);
    }
    if (traced.request.firstRay != sums.rays || sums.sum.size() != traced.visibility.size()) {
        return {}; // traced twice
    }
    for (std::size_t i = 0; i < sums.sum.size(); ++i) {
        sums.sum[i] += traced.visibility[i] * static_cast<float>(traced.request.rays);
    }
    sums.rays += traced.request.rays;
    const Status status = upload(projector, traced, sums);
    projector.tiles.setPasses(tile, projector.tiles.passes(tile) + 1);
    if (projector.tiles.passes(tile) >= passes()) {
        workOf(projector.id()).tiles.erase(tile);
    }
    return status;
}

Status RayTracedTexels::upload(CubeMapProjector& projector, const TracedTexels& traced,
                               const Tile& tile) {
    const TexelRequest& request = traced.request;
    const bool sees = std::any_of(traced.distance.begin(), traced.distance.end(),
                                  [](float distance) { return distance >= 0.0F; });
    if (!sees && !projector.keeps(request.face)) {
        return {};
    }
    if (!workOf(projector.id()).spans) {
        const DistanceRange range = distanceRange(context_.scene, projector.position());
        projector.spanDistances(store_, range.nearest, range.farthest);
        workOf(projector.id()).spans = true;
    }
    if (Status status = projector.keepFace(store_, request.face); !status) {
        return status;
    }
    std::vector<std::uint8_t> visibility(traced.distance.size(), 255);
    std::vector<std::uint16_t> depth(traced.distance.size(), 0);
    const glm::vec2 code = projector.depthCode();
    for (std::size_t i = 0; i < traced.distance.size(); ++i) {
        if (traced.distance[i] < 0.0F) {
            continue;
        }
        const auto column = static_cast<int>(i) % request.width;
        const auto row = static_cast<int>(i) / request.width;
        const glm::vec2 uv = (glm::vec2(request.x + column, request.y + row) + 0.5F) /
                             static_cast<float>(request.faceSize);
        const float along = traced.distance[i] / glm::length(shared::faceDirection(0, uv));
        visibility[i] = static_cast<std::uint8_t>(std::lround(
            255.0F * std::clamp(tile.sum[i] / static_cast<float>(tile.rays), 0.0F, 1.0F)));
        depth[i] = static_cast<std::uint16_t>(
            std::lround(65535.0F * shared::encodeDistance(along, code.x, code.y)));
    }
    store_.upload(projector.layer(request.face),
                  {request.face, request.x, request.y, request.width, request.height}, visibility,
                  depth);
    return {};
}

} // namespace aolib
