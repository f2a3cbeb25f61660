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

/// Of the rays that tiles which begin again take, so many more go to tiles that are to be refined:
/// what never rests leaves a third of the work to what does.
constexpr double kRefinedShare = 0.5;
/// Rays beyond which that debt does not grow: those of a few tiles.
constexpr double kMostOwed = 4e6;
/// Texels about those that are measured in which a surface may be that none of them sees.
constexpr float kBetweenTexels = 2.0F;

std::uint32_t number(const CubeMapProjector& projector) {
    return static_cast<std::uint32_t>(projector.id());
}

/// Where on its face the middle of a request's texel lies, 0 to 1.
glm::vec2 texelAt(const TexelRequest& request, std::size_t number) {
    const auto column = static_cast<int>(number) % request.width;
    const auto row = static_cast<int>(number) / request.width;
    return (glm::vec2(request.x + column, request.y + row) + 0.5F) /
           static_cast<float>(request.faceSize);
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
        const bool reached = within.meets(shown.surfaces);
        const bool seen = seenFrom <= shown.farthest && projector.looksAt(tile, change.region);
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
                                   {.changedIn = queue_.scene()});
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
            .radius = radius_,
            .falloff = context_.options.falloff,
            .sights = {}};
}

void RayTracedTexels::request(const std::vector<CubeMapProjector*>& projectors) {
    const Lists wanted = lists(projectors);
    if (wanted.first.empty() && wanted.refined.empty()) {
        return;
    }
    const auto keyOf = [](const Wanted& w) {
        return TileKey{number(*w.projector), w.detail, w.tile}.packed();
    };
    // What a worker has begun would be begun again: the queue is only exchanged when it runs low or
    // a tile without a pass is not in it.
    const bool low = queue_.pending(TracerQueue::Asker::Texels) <= queued_ / 4;
    if (!low && std::ranges::all_of(wanted.first, [&](const Wanted& w) {
            return queuedFirst_.contains(keyOf(w));
        })) {
        return;
    }
    const std::set<std::uint64_t> before = std::exchange(queuedRefined_, {});
    queuedFirst_.clear();
    std::vector<TexelRequest> queue;
    double owed = owed_;
    auto first = wanted.first.begin();
    auto refined = wanted.refined.begin();
    while (queue.size() < kQueue) {
        const bool begins = first != wanted.first.end();
        if (!begins && refined == wanted.refined.end()) {
            break;
        }
        const bool refines =
            refined != wanted.refined.end() && (!begins || owed >= cost(requestFor(*refined)));
        const Wanted& next = refines ? *refined++ : *first++;
        const std::uint64_t key = keyOf(next);
        if (refines && begins && before.contains(key)) {
            continue; // queued before the others: perhaps begun, else its turn comes again
        }
        queue.push_back(requestFor(next));
        (refines ? queuedRefined_ : queuedFirst_).insert(key);
        if (refines) {
            owed -= cost(queue.back());
        } else if (next.projector->tiles.known(next.tile)) {
            owed += kRefinedShare * cost(queue.back());
        }
    }
    queued_ = queue.size();
    queue_.request(TracerQueue::Asker::Texels, std::move(queue));
}

void RayTracedTexels::account(const TracedTexels& traced, bool begunAgain) {
    if (begunAgain) {
        owed_ = std::min(owed_ + kRefinedShare * cost(traced.request), kMostOwed);
    } else if (traced.request.firstRay > 0) {
        owed_ = std::max(owed_ - cost(traced.request), 0.0);
    }
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
            queuedRefined_.erase(traced.request.key);
            const auto found =
                std::find_if(projectors.begin(), projectors.end(), [&](const auto* projector) {
                    return number(*projector) == key.cubeMap;
                });
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
    return traced.request.radius == radius_ && traced.scene >= shown(projector, tile).changedIn;
}

AoStatus RayTracedTexels::take(CubeMapProjector& projector, const TracedTexels& traced, int tile) {
    spanScene(projector);
    const int had = projector.tiles.passes(tile);
    account(traced, had == 0 && projector.tiles.known(tile));
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
    const AoStatus status = upload(projector, traced, sums, tile);
    projector.tiles.setPasses(tile, had + 1);
    if (had + 1 >= passes()) {
        work.tiles.erase(tile);
    }
    return status;
}

AoStatus RayTracedTexels::takeOutdated(CubeMapProjector& projector, const TracedTexels& traced,
                                       int tile) {
    Tile alone;
    if (traced.request.firstRay > 0 || traced.scene < shown(projector, tile).scene ||
        !add(alone, traced)) {
        return {};
    }
    const AoStatus status = upload(projector, traced, alone, tile);
    projector.tiles.setKnown(tile);
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
        const float along =
            traced.distance[i] / glm::length(shared::faceDirection(0, texelAt(request, i)));
        codes.visibility[i] = static_cast<std::uint8_t>(std::lround(
            255.0F * std::clamp(tile.sum[i] / static_cast<float>(tile.rays), 0.0F, 1.0F)));
        codes.depth[i] =
            static_cast<std::uint16_t>(std::lround(65535.0F * shared::encodeDistance(along, code)));
    }
    return codes;
}

AoStatus RayTracedTexels::upload(CubeMapProjector& projector, const TracedTexels& traced,
                                 const Tile& sums, int tile) {
    const TexelRequest& request = traced.request;
    Work& work = workOf(projector);
    Shown& shown = work.shown[static_cast<std::size_t>(tile)];
    shown.scene = traced.scene;
    measure(shown, projector, traced);
    if (request.firstRay == 0) {
        projector.dropBlocks(store_, blocks_, tile); // of an older scene
        work.details.erase(tile);
    }
    if (shown.surfaces.empty() && !projector.keeps(request.face)) {
        return {};
    }
    if (AoStatus status = projector.keepFace(store_, request.face); !status) {
        return status;
    }
    const Codes codes = encode(projector, traced, sums);
    store_.upload(projector.layer(request.face), {request.x, request.y},
                  {request.width, request.height}, codes.visibility, codes.depth);
    return {};
}

void RayTracedTexels::measure(Shown& shown, const CubeMapProjector& projector,
                              const TracedTexels& traced) {
    const TexelRequest& request = traced.request;
    shown.surfaces = {};
    shown.farthest = 0.0F;
    float reach = 0.0F;
    for (std::size_t i = 0; i < traced.distance.size(); ++i) {
        if (traced.distance[i] < 0.0F) {
            shown.farthest = kInfinite;
            continue;
        }
        const glm::vec3 direction = shared::faceDirection(request.face, texelAt(request, i));
        shown.surfaces.include(projector.position() +
                               traced.distance[i] * glm::normalize(direction));
        reach = std::max(reach, traced.distance[i]);
    }
    shown.farthest = std::max(shown.farthest, reach);
    shown.surfaces = shown.surfaces.inflated(2.0F * kBetweenTexels * reach /
                                             static_cast<float>(request.faceSize));
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
