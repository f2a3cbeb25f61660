#include "backbone/cubemapped/RayTracedTexels.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

#include "backbone/cubemapped/FaceCapture.h"
#include "backbone/cubemapped/RoughTiles.h"
#include "backbone/cubemapped/TileKey.h"

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

/// Rays of a request.
double cost(const TexelRequest& request) {
    return double(request.rays) * request.width * request.height;
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

void RayTracedTexels::sceneChanged(CubeMapProjector& projector, const Scene::Change& change,
                                   float reach) {
    Work& work = workOf(projector);
    work.spans = false;
    const glm::vec3 centre = projector.position();
    const Bounds within = change.region.inflated(reach);
    const float seenFrom = change.region.nearest(centre);
    for (const int tile : projector.tilesTowards(within)) {
        Shown& shown = work.shown[static_cast<std::size_t>(tile)];
        // Occluded from there, or else hidden by it or no longer.
        const bool reached = within.meets(shown.seen.surfaces);
        const bool seen = seenFrom <= shown.seen.farthest && projector.looksAt(tile, change.region);
        if (!reached && !seen) {
            continue;
        }
        shown.changedIn = queue_.scene();
        if (projector.tiles.known(tile)) {
            projector.tiles.setOutdated(tile);
            projector.outdated = true;
        }
    }
}

void RayTracedTexels::restart(CubeMapProjector& projector) {
    Work& work = workOf(projector);
    for (int tile = 0; tile < projector.tiles.count(); ++tile) {
        if (projector.tiles.outdated(tile)) {
            projector.tiles.restart(tile);
            work.tiles.erase(tile);
            work.details.erase(tile);
        }
    }
}

RayTracedTexels::Work& RayTracedTexels::workOf(const CubeMapProjector& projector) {
    const auto [found, isNew] = works_.try_emplace(projector.id());
    if (isNew) { // what was asked for before may be traced in an older scene
        found->second.shown.assign(static_cast<std::size_t>(projector.tiles.count()),
                                   {.scene = 0, .changedIn = queue_.scene(), .seen = {}});
    }
    return found->second;
}

const RayTracedTexels::Shown& RayTracedTexels::shown(const CubeMapProjector& projector, int tile) {
    return workOf(projector).shown[static_cast<std::size_t>(tile)];
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
        projector->shown = projector->shown || projector->tiles.allKnown();
    }
    return {};
}

// ---- What is asked for --------------------------------------------------------------------------

RayTracedTexels::Lists RayTracedTexels::lists(const std::vector<CubeMapProjector*>& projectors) {
    Lists lists;
    const int most = passes();
    for (CubeMapProjector* projector : projectors) {
        const TileProgress& tiles = projector->tiles;
        for (int tile = 0; tile < tiles.count(); ++tile) {
            if (tiles.asked(tile) && tiles.passes(tile) < most) {
                auto& list = tiles.passes(tile) == 0 ? lists.first : lists.refined;
                list.push_back({projector, tile, false, tiles.passes(tile)});
            }
            if (tiles.blocksNeeded(tile) > 0 && tiles.blockPasses(tile) < most) {
                lists.refined.push_back({projector, tile, true, tiles.blockPasses(tile)});
            }
        }
    }
    // What shows nothing yet, then what shows the oldest scene.
    std::stable_sort(lists.first.begin(), lists.first.end(), [&](const Wanted& a, const Wanted& b) {
        const auto rank = [&](const Wanted& w) {
            return std::pair(w.projector->tiles.known(w.tile), shown(*w.projector, w.tile).scene);
        };
        return rank(a) < rank(b);
    });
    // Among equals, what the whole view lacks before what its edges lack.
    std::stable_sort(lists.refined.begin(), lists.refined.end(),
                     [](const Wanted& a, const Wanted& b) {
                         return std::pair(a.passes, a.detail) < std::pair(b.passes, b.detail);
                     });
    return lists;
}

TexelRequest RayTracedTexels::requestFor(const Wanted& wanted) const {
    const CubeMapProjector& projector = *wanted.projector;
    const TileProgress::Region region = projector.tiles.region(wanted.tile);
    const int scale = wanted.detail ? blocks_.scale() : 1;
    const int before = raysAfter(wanted.passes);
    return {.key = TileKey{number(projector), wanted.detail, wanted.tile}.packed(),
            .centre = projector.position(),
            .faceSize = scale * projector.tiles.faceSize(),
            .face = region.face,
            .x = scale * region.x,
            .y = scale * region.y,
            .width = scale * region.width,
            .height = scale * region.height,
            .firstRay = before,
            .rays = raysAfter(wanted.passes + 1) - before,
            .radius = context_.options.radius,
            .falloff = context_.options.falloff,
            .sights = {}};
}

void RayTracedTexels::request(const std::vector<CubeMapProjector*>& projectors) {
    const Lists wanted = lists(projectors);
    if (wanted.first.empty() && wanted.refined.empty()) {
        return;
    }
    std::map<std::uint64_t, TexelRequest> requests;
    const auto turnsOf = [&](const std::vector<Wanted>& list) {
        std::vector<TileTurns::Tile> tiles;
        for (const Wanted& one : list) {
            const TexelRequest request = requestFor(one);
            tiles.push_back({request.key, cost(request), one.projector->tiles.known(one.tile)});
            requests.emplace(request.key, request);
        }
        return tiles;
    };
    const std::vector<TileTurns::Tile> first = turnsOf(wanted.first);
    // What a worker has begun would be begun again: the queue is only exchanged when it runs low or
    // a tile without a pass is not in it.
    const bool low = queue_.pending(TracerQueue::Asker::Texels) <= queued_ / 4;
    if (!low && turns_.has(first)) {
        return;
    }
    std::vector<TexelRequest> queue;
    for (const std::uint64_t key : turns_.order(first, turnsOf(wanted.refined), kQueue)) {
        queue.push_back(requests.at(key));
    }
    queued_ = queue.size();
    queue_.request(TracerQueue::Asker::Texels, std::move(queue));
}

// ---- What has come ------------------------------------------------------------------------------

bool RayTracedTexels::fits(const CubeMapProjector& projector, const TracedTexels& traced,
                           bool detail) const {
    const TexelRequest& request = traced.request;
    const int scale = detail ? blocks_.scale() : 1;
    return request.centre == projector.position() &&
           request.faceSize == scale * projector.tiles.faceSize() &&
           request.falloff == context_.options.falloff;
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
            const bool again = found != projectors.end() && (*found)->tiles.known(key.tile);
            turns_.answered({traced.request.key, cost(traced.request), again},
                            traced.request.firstRay > 0 || key.detail);
            // One that is gone, or too far away meanwhile, is asked for again when it is back.
            if (found == projectors.end() || !fits(**found, traced, key.detail)) {
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

bool RayTracedTexels::counts(const CubeMapProjector& projector, const TracedTexels& traced,
                             int tile) {
    return traced.request.radius == context_.options.radius &&
           traced.scene >= shown(projector, tile).changedIn;
}

AoStatus RayTracedTexels::take(CubeMapProjector& projector, const TracedTexels& traced, int tile) {
    spanScene(projector);
    const int had = projector.tiles.passes(tile);
    if (!counts(projector, traced, tile)) {
        return had == 0 ? takeOutdated(projector, traced, tile) : AoStatus();
    }
    if (had >= passes()) {
        return {}; // traced twice: the sums of a complete tile are gone, these would begin new ones
    }
    Work& work = workOf(projector);
    Tile& sums = work.tiles[tile];
    if (!add(sums, traced)) {
        return {};
    }
    if (had == 0 && isRough(traced)) {
        projector.tiles.offerBlocks(tile, 1);
    }
    if (AoStatus status = upload(projector, traced, sums, tile); !status) {
        projector.tiles.setOutdated(tile); // it is added up, but not shown
        projector.outdated = true;
        return status;
    }
    projector.tiles.setPasses(tile, had + 1);
    if (had + 1 >= passes()) {
        work.tiles.erase(tile);
    }
    return {};
}

AoStatus RayTracedTexels::takeOutdated(CubeMapProjector& projector, const TracedTexels& traced,
                                       int tile) {
    Tile alone;
    if (traced.request.firstRay > 0 || traced.scene < shown(projector, tile).scene ||
        !add(alone, traced)) {
        return {};
    }
    AoStatus status = upload(projector, traced, alone, tile);
    if (status) {
        projector.tiles.setKnown(tile);
    }
    return status;
}

AoStatus RayTracedTexels::takeDetail(CubeMapProjector& projector, const TracedTexels& traced,
                                     int tile) {
    if (projector.tiles.blockPasses(tile) >= passes() || !counts(projector, traced, tile)) {
        return {}; // as above
    }
    Work& work = workOf(projector);
    Tile& sums = work.details[tile];
    if (!projector.keeps(traced.request.face) || !add(sums, traced)) {
        return {};
    }
    const auto block = projector.blockOf(store_, blocks_, tile);
    if (!block) {
        work.details.erase(tile);
        if (store_.spare() > 0) {
            return block.status();
        }
        projector.tiles.refuseBlock(tile); // what the face keeps has to do
        return {};
    }
    const TexelCodes codes = encodeTexels(traced, sums.sum, sums.rays, projector.depthCode());
    blocks_.upload(*block, traced.request.width, traced.request.height, codes.visibility,
                   codes.depth);
    projector.tiles.setBlockPasses(tile, projector.tiles.blockPasses(tile) + 1);
    if (projector.tiles.blockPasses(tile) >= passes()) {
        work.details.erase(tile);
    }
    return {};
}

AoStatus RayTracedTexels::upload(CubeMapProjector& projector, const TracedTexels& traced,
                                 const Tile& sums, int tile) {
    const TexelRequest& request = traced.request;
    Work& work = workOf(projector);
    Shown& shown = work.shown[static_cast<std::size_t>(tile)];
    shown.scene = traced.scene;
    shown.seen = seenSurfaces(traced);
    if (request.firstRay == 0) {
        projector.dropBlocks(store_, blocks_, tile); // of an older scene
        work.details.erase(tile);
    }
    if (shown.seen.surfaces.empty() && !projector.keeps(request.face)) {
        return {};
    }
    if (AoStatus status = projector.keepFace(store_, request.face); !status) {
        return status;
    }
    const TexelCodes codes = encodeTexels(traced, sums.sum, sums.rays, projector.depthCode());
    store_.upload(projector.layer(request.face), {request.x, request.y},
                  {request.width, request.height}, codes.visibility, codes.depth);
    return {};
}

void RayTracedTexels::spanScene(CubeMapProjector& projector) {
    Work& work = workOf(projector);
    if (std::exchange(work.spans, true)) {
        return;
    }
    const DistanceRange range = distanceRange(context_.scene, projector.position());
    if (projector.spanDistances(store_, blocks_, range.nearest, range.farthest)) {
        work.tiles.clear();
        work.details.clear();
    }
}

} // namespace aolib
