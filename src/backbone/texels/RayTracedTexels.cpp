#include "backbone/texels/RayTracedTexels.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

#include "backbone/estimators/Estimators.h"
#include "backbone/texels/FaceCapture.h"
#include "backbone/texels/RoughTiles.h"
#include "backbone/texels/TileKey.h"

namespace aolib {

namespace {

/// Tiles queued at a time: enough to keep workers busy between frames.
constexpr std::size_t kQueue = 512;

std::uint32_t number(const CubeMapProjector& projector) {
    return static_cast<std::uint32_t>(projector.id());
}

/// Rays of a request.
double cost(const TexelRequest& request) {
    return double(request.rays) * request.width * request.height;
}

} // namespace

bool RayTracedTexels::hasPending(const CubeMapProjector& projector) const {
    return projector.tiles().hasPending(passes()) || projector.tiles().hasPendingPages(passes());
}

int RayTracedTexels::passes() const {
    return traitsOf(context_.options.estimator).passes(context_.options);
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
        if (projector.tiles().isKnown(tile)) {
            projector.setOutdated(tile);
        }
    }
}

void RayTracedTexels::restart(CubeMapProjector& projector) {
    Work& work = workOf(projector);
    for (int tile = 0; tile < projector.tiles().count(); ++tile) {
        if (projector.tiles().isOutdated(tile)) {
            projector.restartTile(tile);
            work.tiles.erase(tile);
            work.pages.erase(tile);
        }
    }
}

RayTracedTexels::Work& RayTracedTexels::workOf(const CubeMapProjector& projector) {
    const auto [found, isNew] = works_.try_emplace(projector.id());
    if (isNew) { // earlier requests may be traced in an older scene
        found->second.shown.assign(static_cast<std::size_t>(projector.tiles().count()),
                                   {.scene = 0, .changedIn = queue_.scene(), .seen = {}});
    }
    return found->second;
}

const RayTracedTexels::Shown& RayTracedTexels::shown(const CubeMapProjector& projector, int tile) {
    return workOf(projector).shown[static_cast<std::size_t>(tile)];
}

AoStatus RayTracedTexels::complete(CubeMapProjector& projector) {
    projector.requestAll();
    beginFrame({&projector});
    while (hasPending(projector)) {
        request();
        queue_.wait(1000.0);
        if (AoStatus status = runToEnd(*this); !status) {
            return status;
        }
        if (!queue_.status()) {
            return queue_.status();
        }
    }
    projector.show();
    return {};
}

AoStatus RayTracedTexels::endFrame() {
    if (!queue_.status()) {
        return queue_.status();
    }
    request();
    for (CubeMapProjector* projector : projectors_) {
        if (projector->tiles().allKnown()) {
            projector->show();
        }
    }
    return {};
}

// ---- What is requested --------------------------------------------------------------------------

RayTracedTexels::Lists RayTracedTexels::lists() {
    Lists lists;
    const int most = passes();
    for (CubeMapProjector* projector : projectors_) {
        const TileTable& tiles = projector->tiles();
        for (int tile = 0; tile < tiles.count(); ++tile) {
            if (tiles.isRequested(tile) && tiles.passes(tile) < most) {
                auto& list = tiles.passes(tile) == 0 ? lists.first : lists.refined;
                list.push_back({projector, tile, false, tiles.passes(tile)});
            }
            if (tiles.pagesNeeded(tile) > 0 && tiles.pagePasses(tile) < most) {
                lists.refined.push_back({projector, tile, true, tiles.pagePasses(tile)});
            }
        }
    }
    // What shows nothing yet, then what shows the oldest scene.
    std::stable_sort(lists.first.begin(), lists.first.end(), [&](const Wanted& a, const Wanted& b) {
        const auto rank = [&](const Wanted& w) {
            return std::pair(w.projector->tiles().isKnown(w.tile),
                             shown(*w.projector, w.tile).scene);
        };
        return rank(a) < rank(b);
    });
    // Among equals, tiles of the whole view before pages, which are its edges'.
    std::stable_sort(lists.refined.begin(), lists.refined.end(),
                     [](const Wanted& a, const Wanted& b) {
                         return std::pair(a.passes, a.detail) < std::pair(b.passes, b.detail);
                     });
    return lists;
}

TexelRequest RayTracedTexels::requestFor(const Wanted& wanted) const {
    const CubeMapProjector& projector = *wanted.projector;
    const TileTable::Region region = projector.tiles().region(wanted.tile);
    const int scale = wanted.detail ? atlas_.pages.scale() : 1;
    const int before = raysAfter(context_.options, wanted.passes);
    return {.key = TileKey{number(projector), wanted.detail, wanted.tile}.packed(),
            .centre = projector.position(),
            .faceSize = scale * projector.tiles().faceSize(),
            .face = region.face,
            .x = scale * region.x,
            .y = scale * region.y,
            .width = scale * region.width,
            .height = scale * region.height,
            .firstRay = before,
            .rays = raysAfter(context_.options, wanted.passes + 1) - before,
            .radius = context_.options.radius,
            .falloff = context_.options.falloff,
            .primaryRays = {}};
}

void RayTracedTexels::request() {
    const Lists wanted = lists();
    if (wanted.first.empty() && wanted.refined.empty()) {
        return;
    }
    std::map<std::uint64_t, TexelRequest> requests;
    const auto turnsOf = [&](const std::vector<Wanted>& list) {
        std::vector<TileTurns::Tile> tiles;
        for (const Wanted& one : list) {
            const TexelRequest request = requestFor(one);
            tiles.push_back({request.key, cost(request), one.projector->tiles().isKnown(one.tile)});
            requests.emplace(request.key, request);
        }
        return tiles;
    };
    const std::vector<TileTurns::Tile> first = turnsOf(wanted.first);
    // What a worker has begun would be begun again: the queue is only exchanged when it runs low or
    // a tile without a pass is not in it.
    const bool low = queue_.pending(TracerQueue::Client::Texels) <= queued_ / 4;
    if (!low && turns_.has(first)) {
        return;
    }
    std::vector<TexelRequest> queue;
    for (const std::uint64_t key : turns_.order(first, turnsOf(wanted.refined), kQueue)) {
        queue.push_back(requests.at(key));
    }
    queued_ = queue.size();
    queue_.request(TracerQueue::Client::Texels, std::move(queue));
}

// ---- What has come ------------------------------------------------------------------------------

bool RayTracedTexels::fits(const CubeMapProjector& projector, const TracedTexels& traced,
                           bool detail) const {
    const TexelRequest& request = traced.request;
    const int scale = detail ? atlas_.pages.scale() : 1;
    return request.centre == projector.position() &&
           request.faceSize == scale * projector.tiles().faceSize() &&
           request.falloff == context_.options.falloff;
}

std::optional<WorkUnit> RayTracedTexels::next() {
    return queue_.hasResult(TracerQueue::Client::Texels) ? std::optional(WorkUnit::Upload)
                                                         : std::nullopt;
}

Result<int> RayTracedTexels::step(int most) {
    const auto results = queue_.take(TracerQueue::Client::Texels, static_cast<std::size_t>(most));
    for (const TracedTexels& traced : results) {
        if (AoStatus status = take(traced); !status) {
            return status;
        }
    }
    return static_cast<int>(results.size());
}

AoStatus RayTracedTexels::take(const TracedTexels& traced) {
    const TileKey key = TileKey::unpacked(traced.request.key);
    const auto found = std::ranges::find_if(
        projectors_, [&](const auto* projector) { return number(*projector) == key.cubeMap; });
    const bool again = found != projectors_.end() && (*found)->tiles().isKnown(key.tile);
    turns_.answered({traced.request.key, cost(traced.request), again},
                    traced.request.firstRay > 0 || key.detail);
    // A cube map that is gone, or too far away meanwhile, requests it again when it is back.
    if (found == projectors_.end() || !fits(**found, traced, key.detail)) {
        return {};
    }
    return key.detail ? takePage(**found, traced, key.tile) : takeFace(**found, traced, key.tile);
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

AoStatus RayTracedTexels::takeFace(CubeMapProjector& projector, const TracedTexels& traced,
                                   int tile) {
    spanScene(projector);
    const int had = projector.tiles().passes(tile);
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
        projector.setAvailablePages(tile, 1);
    }
    if (AoStatus status = upload(projector, traced, sums, tile); !status) {
        projector.setOutdated(tile); // it is added up, but not shown
        return status;
    }
    projector.recordPasses(tile, had + 1);
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
        projector.recordOutdatedTexels(tile);
    }
    return status;
}

AoStatus RayTracedTexels::takePage(CubeMapProjector& projector, const TracedTexels& traced,
                                   int tile) {
    if (projector.tiles().pagePasses(tile) >= passes() || !counts(projector, traced, tile)) {
        return {}; // as above
    }
    Work& work = workOf(projector);
    Tile& sums = work.pages[tile];
    if (!projector.hasFace(traced.request.face) || !add(sums, traced)) {
        return {};
    }
    const auto page = projector.firstPage(tile);
    if (!page) {
        work.pages.erase(tile);
        if (atlas_.faces.freeLayers() > 0) {
            return page.status();
        }
        projector.denyPages(tile); // what the face keeps has to do
        return {};
    }
    const TexelCodes codes = encodeTexels(traced, sums.sum, sums.rays, projector.depthCode());
    atlas_.pages.upload(*page, traced.request.width, traced.request.height, codes.visibility,
                        codes.depth);
    projector.recordPagePasses(tile, projector.tiles().pagePasses(tile) + 1);
    if (projector.tiles().pagePasses(tile) >= passes()) {
        work.pages.erase(tile);
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
        projector.releasePages(tile); // of an older scene
        work.pages.erase(tile);
    }
    if (shown.seen.surfaces.empty() && !projector.hasFace(request.face)) {
        return {};
    }
    if (AoStatus status = projector.allocateFace(request.face); !status) {
        return status;
    }
    const TexelCodes codes = encodeTexels(traced, sums.sum, sums.rays, projector.depthCode());
    atlas_.faces.upload(projector.layer(request.face), {request.x, request.y},
                        {request.width, request.height}, codes.visibility, codes.depth);
    return {};
}

void RayTracedTexels::spanScene(CubeMapProjector& projector) {
    Work& work = workOf(projector);
    if (std::exchange(work.spans, true)) {
        return;
    }
    const DistanceRange range = distanceRange(context_.scene, projector.position());
    if (projector.spanDistances(range.nearest, range.farthest)) {
        work.tiles.clear();
        work.pages.clear();
    }
}

} // namespace aolib
