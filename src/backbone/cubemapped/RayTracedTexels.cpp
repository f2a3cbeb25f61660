#include "backbone/cubemapped/RayTracedTexels.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

#include "backbone/cubemapped/FaceCapture.h"
#include "backbone/cubemapped/RoughTiles.h"
#include "backbone/cubemapped/TileKey.h"
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
/// Results that are taken before the clock is looked at again: a block of detail takes a while.
constexpr std::size_t kAtATime = 1;

std::uint32_t number(const CubeMapProjector& projector) {
    return static_cast<std::uint32_t>(projector.id());
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

bool RayTracedTexels::lacks(const CubeMapProjector& projector) const {
    return projector.tiles.lacks(passes()) || projector.tiles.lacksBlocks(passes());
}

int RayTracedTexels::passes() const {
    int count = 1;
    while (raysAfter(count) < context_.options.rayTraced.rays) {
        ++count;
    }
    return count;
}

void RayTracedTexels::sceneChanged() {
    for (auto& [id, work] : works_) {
        work.generation = nextGeneration();
    }
    askedBefore_ = 0;
}

std::uint32_t RayTracedTexels::nextGeneration() {
    generations_ = (generations_ + 1U) % (1U << TileKey::kGenerationBits);
    return generations_;
}

RayTracedTexels::Work& RayTracedTexels::workOf(CubeMapId id) {
    const auto [found, isNew] = works_.try_emplace(id);
    if (isNew) {
        found->second.generation = nextGeneration();
    }
    return found->second;
}

void RayTracedTexels::forget(CubeMapId id) {
    works_.erase(id);
    askedBefore_ = 0;
}

AoStatus RayTracedTexels::complete(CubeMapProjector& projector) {
    projector.tiles.askAll();
    const std::vector<CubeMapProjector*> one{&projector};
    while (lacks(projector)) {
        request(one);
        queue_.wait(1000.0);
        if (AoStatus status = takeResults(one, HUGE_VAL); !status) {
            return status;
        }
    }
    projector.shown = true;
    return {};
}

AoStatus RayTracedTexels::advance(const std::vector<CubeMapProjector*>& projectors,
                                  double milliseconds) {
    if (AoStatus status = takeResults(projectors, milliseconds); !status) {
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
        int passes; ///< that it has had
        bool detail;
        CubeMapProjector* projector;
        int tile;
    };
    std::vector<Wanted> wanted;
    int asked = 0;
    const int most = passes();
    for (CubeMapProjector* projector : projectors) {
        const TileProgress& tiles = projector->tiles;
        for (int tile = 0; tile < tiles.count(); ++tile) {
            asked += tiles.asked(tile) ? 1 : 0;
            if (tiles.asked(tile) && tiles.passes(tile) < most) {
                wanted.push_back({tiles.passes(tile), false, projector, tile});
            }
            if (tiles.blocksNeeded(tile) > 0) {
                asked += 1;
                if (tiles.blockPasses(tile) < most) {
                    wanted.push_back({tiles.blockPasses(tile), true, projector, tile});
                }
            }
        }
    }
    // What a worker has begun would be begun again: the queue is only exchanged when it runs low or
    // something new is asked for.
    const bool low = queue_.pending(TracerQueue::Asker::Texels) <= queued_ / 4;
    if (wanted.empty() || (asked == askedBefore_ && !low)) {
        return;
    }
    askedBefore_ = asked;
    std::stable_sort(wanted.begin(), wanted.end(), [](const Wanted& a, const Wanted& b) {
        // Among equals, what the whole view lacks before what its edges lack.
        return std::pair(a.passes, a.detail) < std::pair(b.passes, b.detail);
    });
    wanted.resize(std::min(wanted.size(), kQueue));
    std::vector<TexelRequest> queue;
    for (const Wanted& one : wanted) {
        const CubeMapProjector& projector = *one.projector;
        const TileProgress::Region region = projector.tiles.region(one.tile);
        const int scale = one.detail ? blocks_.scale() : 1;
        const int before = raysAfter(one.passes);
        const TileKey key{number(projector), one.detail, one.tile,
                          workOf(projector.id()).generation};
        queue.push_back({.key = key.packed(),
                         .centre = projector.position(),
                         .faceSize = scale * projector.tiles.faceSize(),
                         .face = region.face,
                         .x = scale * region.x,
                         .y = scale * region.y,
                         .width = scale * region.width,
                         .height = scale * region.height,
                         .firstRay = before,
                         .rays = raysAfter(one.passes + 1) - before,
                         .radius = radius_,
                         .falloff = context_.options.falloff,
                         .sights = {}});
    }
    queued_ = queue.size();
    queue_.request(TracerQueue::Asker::Texels, std::move(queue));
}

AoStatus RayTracedTexels::takeResults(const std::vector<CubeMapProjector*>& projectors,
                                      double milliseconds) {
    const auto start = std::chrono::steady_clock::now();
    for (auto results = queue_.take(TracerQueue::Asker::Texels, kAtATime); !results.empty();
         results = queue_.take(TracerQueue::Asker::Texels, kAtATime)) {
        for (const TracedTexels& traced : results) {
            const TileKey key = TileKey::unpacked(traced.request.key);
            const auto found =
                std::find_if(projectors.begin(), projectors.end(), [&](const auto* projector) {
                    return number(*projector) == key.cubeMap;
                });
            // One that is gone, or too far away meanwhile, is asked for again when it is back.
            if (found == projectors.end() || workOf((*found)->id()).generation != key.generation) {
                continue;
            }
            AoStatus status = key.detail ? takeDetail(**found, traced, key.tile)
                                         : take(**found, traced, key.tile);
            if (!status) {
                return status;
            }
        }
        const std::chrono::duration<double, std::milli> spent =
            std::chrono::steady_clock::now() - start;
        if (spent.count() >= milliseconds) {
            break;
        }
    }
    return queue_.status();
}

bool RayTracedTexels::add(Tile& sums, const TracedTexels& traced) {
    if (sums.sum.empty()) {
        sums.sum.resize(traced.visibility.size(), 0.0F);
    }
    if (traced.request.firstRay != sums.rays || sums.sum.size() != traced.visibility.size()) {
        return false; // traced twice
    }
    for (std::size_t i = 0; i < sums.sum.size(); ++i) {
        sums.sum[i] += traced.visibility[i] * static_cast<float>(traced.request.rays);
    }
    sums.rays += traced.request.rays;
    return true;
}

AoStatus RayTracedTexels::take(CubeMapProjector& projector, const TracedTexels& traced, int tile) {
    if (projector.tiles.passes(tile) >= passes()) {
        return {}; // traced twice: the sums of a complete tile are gone, these would begin new ones
    }
    Work& work = workOf(projector.id());
    Tile& sums = work.tiles[tile];
    if (!add(sums, traced)) {
        return {};
    }
    if (traced.request.firstRay == 0 && isRough(traced)) {
        projector.tiles.offerBlocks(tile, 1);
    }
    const AoStatus status = upload(projector, traced, sums);
    projector.tiles.setPasses(tile, projector.tiles.passes(tile) + 1);
    if (projector.tiles.passes(tile) >= passes()) {
        work.tiles.erase(tile);
    }
    return status;
}

AoStatus RayTracedTexels::takeDetail(CubeMapProjector& projector, const TracedTexels& traced,
                                     int tile) {
    if (projector.tiles.blockPasses(tile) >= passes()) {
        return {}; // as above
    }
    Work& work = workOf(projector.id());
    Tile& sums = work.details[tile];
    if (!projector.keeps(traced.request.face) || !add(sums, traced)) {
        return {};
    }
    const auto block = projector.blockOf(store_, blocks_, tile);
    if (!block) {
        if (store_.spare() > 0) {
            return block.status();
        }
        projector.tiles.refuseBlock(tile); // what the face keeps has to do
        work.details.erase(tile);
        return {};
    }
    const Codes codes = encode(projector, traced, sums);
    blocks_.upload(*block, traced.request.width, traced.request.height, codes.visibility,
                   codes.depth);
    projector.tiles.setBlockPasses(tile, projector.tiles.blockPasses(tile) + 1);
    if (projector.tiles.blockPasses(tile) >= passes()) {
        work.details.erase(tile);
    }
    return {};
}

RayTracedTexels::Codes RayTracedTexels::encode(const CubeMapProjector& projector,
                                               const TracedTexels& traced, const Tile& tile) {
    const TexelRequest& request = traced.request;
    Codes codes{std::vector<std::uint8_t>(traced.distance.size(), 255),
                std::vector<std::uint16_t>(traced.distance.size(), 0)};
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
        codes.visibility[i] = static_cast<std::uint8_t>(std::lround(
            255.0F * std::clamp(tile.sum[i] / static_cast<float>(tile.rays), 0.0F, 1.0F)));
        codes.depth[i] =
            static_cast<std::uint16_t>(std::lround(65535.0F * shared::encodeDistance(along, code)));
    }
    return codes;
}

AoStatus RayTracedTexels::upload(CubeMapProjector& projector, const TracedTexels& traced,
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
    if (AoStatus status = projector.keepFace(store_, request.face); !status) {
        return status;
    }
    const Codes codes = encode(projector, traced, tile);
    store_.upload(projector.layer(request.face), {request.x, request.y},
                  {request.width, request.height}, codes.visibility, codes.depth);
    return {};
}

} // namespace aolib
