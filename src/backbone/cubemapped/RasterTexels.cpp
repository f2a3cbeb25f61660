#include "backbone/cubemapped/RasterTexels.h"

#include <algorithm>
#include <utility>

#include "backbone/Estimators.h"

namespace aolib {

namespace {

/// Passes of every tile before a cube map is shown for the first time.
constexpr int kFirstPasses = 2;

} // namespace

Result<std::unique_ptr<RasterTexels>> RasterTexels::create(const BackboneContext& context,
                                                           const SceneGeometry& geometry,
                                                           FaceStore& store, BlockStore& blocks) {
    std::unique_ptr<RasterTexels> texels(new RasterTexels(context, geometry, store, blocks));
    auto shading = DeferredShading::create(context);
    if (!shading) {
        return shading.status();
    }
    auto sight = SightTest::create(context);
    if (!sight) {
        return sight.status();
    }
    auto budget = FrameBudget::create(context.gl);
    if (!budget) {
        return budget.status();
    }
    texels->shading_ = std::move(*shading);
    texels->sight_ = std::move(*sight);
    texels->budget_ = std::move(*budget);
    return texels;
}

Result<RasterTexels::Work*> RasterTexels::begin(CubeMapProjector& projector) {
    auto capture = shading_.begin(context_, geometry_, projector, store_, blocks_);
    if (!capture) {
        return capture.status();
    }
    Work& work = works_[projector.id()];
    work = {};
    work.capture = std::move(*capture);
    work.mayBreak = !brokenOff_.contains(projector.id());
    for (int tile = 0; tile < projector.tiles.count();
         ++tile) { // what was begun went with the last
        const int had = projector.tiles.blockPasses(tile);
        projector.tiles.setBlockPasses(tile, had - had % passes());
    }
    return &work;
}

void RasterTexels::sceneChanged(CubeMapProjector& projector, const Scene::Change& change,
                                float reach) {
    const Bounds region = change.region.inflated(reach);
    // What it keeps does not tell what a capture on its way sees.
    if (capturing(projector.id()) || sight_.sees(context_, projector, store_, region)) {
        for (const int tile : projector.tilesTowards(region)) {
            projector.tiles.setOutdated(tile);
            projector.outdated = true;
        }
    } else if (blocks_.scale() == 1) { // of what it does not see
        projector.dropBlocks(store_, blocks_, region);
        if (const auto work = works_.find(projector.id()); work != works_.end()) {
            work->second.changed.include(region);
        }
    }
}

bool RasterTexels::mayRestart(const CubeMapProjector& projector) const {
    const auto work = works_.find(projector.id());
    if (work == works_.end() || !lacks(projector)) {
        return true;
    }
    return work->second.mayBreak && work->second.capture.ready &&
           projector.tiles.fewestPasses() >= std::min(kFirstPasses, passes());
}

void RasterTexels::restart(CubeMapProjector& projector) {
    const bool breaksOff = works_.contains(projector.id()) && lacks(projector);
    if (breaksOff) {
        brokenOff_.insert(projector.id());
    } else {
        brokenOff_.erase(projector.id());
    }
    works_.erase(projector.id());
    for (int tile = 0; tile < projector.tiles.count(); ++tile) {
        // What the last capture has added up of the others is gone with it.
        if (projector.tiles.outdated(tile) || projector.tiles.passes(tile) < passes()) {
            projector.dropBlocks(store_, blocks_, tile);
            projector.tiles.restart(tile);
        }
    }
}

bool RasterTexels::lacks(const CubeMapProjector& projector) const {
    const auto work = works_.find(projector.id());
    const bool atOnce = context_.options.frameBudget <= 0.0F; // no view has asked yet
    return projector.tiles.lacks(passes()) || (!atOnce && projector.tiles.lacksBlocks(passes())) ||
           (work != works_.end() && !work->second.toKeep.empty());
}

bool RasterTexels::keeps(const CubeMapProjector& projector) const {
    const auto work = works_.find(projector.id());
    return work == works_.end() || work->second.toKeep.empty();
}

bool RasterTexels::capturing(CubeMapId id) const {
    const auto work = works_.find(id);
    return work != works_.end() && !work->second.capture.ready;
}

// ---- At once ------------------------------------------------------------------------------------

AoStatus RasterTexels::complete(CubeMapProjector& projector) {
    projector.timer.begin();
    const auto work = begin(projector);
    if (!work) {
        return work.status();
    }
    const CubeMapCapture& capture = (*work)->capture;
    while (!capture.ready) {
        if (AoStatus status = shading_.step(context_, (*work)->capture, projector, store_);
            !status) {
            forget(projector.id());
            return status;
        }
    }
    const int size = store_.faceSize();
    for (int face = 0; face < kFaces; ++face) {
        if (projector.keeps(face)) {
            shading_.accumulate(context_, capture, {face, 0, 0, size, size}, 0, passes());
        }
    }
    for (int face = 0; face < kFaces; ++face) {
        if (projector.keeps(face)) {
            shading_.resolve(context_, capture, projector, store_, {face, 0, 0, size, size}, 1.0F);
        }
    }
    projector.tiles.askAll();
    for (int tile = 0; tile < projector.tiles.count(); ++tile) {
        projector.tiles.setPasses(tile, passes());
    }
    projector.shown = true;
    projector.timer.end();
    forget(projector.id());
    return {};
}

// ---- Within a budget ----------------------------------------------------------------------------

AoStatus RasterTexels::advance(const std::vector<CubeMapProjector*>& projectors,
                               double milliseconds) {
    for (auto& [id, work] : works_) {
        ++work.idleFrames;
    }
    bool began = false;
    bool room = true;
    for (CubeMapProjector* projector : projectors) {
        if (!room || !lacks(*projector)) {
            continue;
        }
        if (!began) {
            budget_.beginFrame(milliseconds);
            began = true;
        }
        const auto left = goOn(*projector);
        if (!left) {
            forget(projector->id());
            return left.status();
        }
        room = *left;
        if (!projector->shown &&
            projector->tiles.fewestPasses() >= std::min(kFirstPasses, passes())) {
            projector->shown = true;
            projector->showsMore = traitsOf(context_.options.estimator).layered;
        }
    }
    std::erase_if(works_, [](const auto& entry) { return entry.second.idleFrames > kIdleFrames; });
    return {};
}

Result<bool> RasterTexels::goOn(CubeMapProjector& projector) {
    auto found = works_.find(projector.id());
    if (found == works_.end()) {
        if (const auto work = begin(projector); !work) {
            return work.status();
        }
        found = works_.find(projector.id());
    }
    Work& work = found->second;
    work.idleFrames = 0;
    if (!work.capture.ready) {
        const auto room = goOnCapturing(projector, work);
        if (!room || !*room) {
            return room;
        }
    }
    if (!goOnComputing(projector, work) || !goOnKeeping(projector, work)) {
        return false;
    }
    return goOnBehind(projector, work);
}

Result<bool> RasterTexels::goOnCapturing(CubeMapProjector& projector, Work& work) {
    while (!work.capture.ready) {
        const WorkUnit unit = work.capture.next();
        if (work.capture.waits() || budget_.room(unit) == 0) {
            return false;
        }
        budget_.start(unit);
        if (AoStatus status = shading_.step(context_, work.capture, projector, store_); !status) {
            return status;
        }
        budget_.done(1);
    }
    return true;
}

bool RasterTexels::goOnComputing(CubeMapProjector& projector, Work& work) {
    while (projector.tiles.lacks(passes())) {
        const int most = budget_.room(WorkUnit::Texels);
        if (most == 0) {
            return false;
        }
        budget_.start(WorkUnit::Texels);
        budget_.done(computeTiles(projector, work, most));
        if (!projector.tiles.lacks(passes()) && traitsOf(context_.options.estimator).layered) {
            work.toKeep = work.tiles; // once more: the smoothing looks across the borders of tiles
        }
    }
    return true;
}

int RasterTexels::computeTiles(CubeMapProjector& projector, Work& work, int most) {
    TileProgress& tiles = projector.tiles;
    std::set<int> computed;
    int units = 0;
    while (units < most && tiles.lacks(passes())) {
        for (const int tile : tiles.mostUrgent(passes())) {
            const TileProgress::Region region = tiles.region(tile);
            const int pass = tiles.passes(tile);
            if (!projector.keeps(region.face)) {
                tiles.setPasses(tile, passes());
                continue;
            }
            shading_.accumulate(context_, work.capture, region, pass, 1);
            tiles.setPasses(tile, pass + 1);
            tiles.offerBlocks(tile, work.capture.geometry->layersOf(region.face) - 1);
            computed.insert(tile);
            if (++units == most) {
                break;
            }
        }
    }
    for (const int tile : computed) {
        keep(projector, work, tile);
    }
    work.tiles.merge(computed);
    return units;
}

bool RasterTexels::goOnKeeping(CubeMapProjector& projector, Work& work) {
    while (!work.toKeep.empty()) {
        const int most = budget_.room(WorkUnit::Keep);
        if (most == 0) {
            return false;
        }
        budget_.start(WorkUnit::Keep);
        int units = 0;
        for (; units < most && !work.toKeep.empty(); ++units) {
            keep(projector, work, work.toKeep.extract(work.toKeep.begin()).value());
        }
        budget_.done(units);
    }
    return true;
}

// ---- Surfaces behind ----------------------------------------------------------------------------

std::optional<int> RasterTexels::nextBehind(const CubeMapProjector& projector,
                                            const Work& work) const {
    std::optional<int> next;
    for (int tile = 0; tile < projector.tiles.count(); ++tile) {
        const bool begun = projector.tiles.blockPasses(tile) % passes() > 0;
        if (projector.tiles.lacksBlocks(tile, passes()) && (begun || !next) &&
            (work.changed.empty() || !projector.looksAt(tile, work.changed))) {
            next = tile;
        }
    }
    return next;
}

Result<bool> RasterTexels::goOnBehind(CubeMapProjector& projector, Work& work) {
    while (projector.tiles.lacksBlocks(passes())) {
        const int most = budget_.room(WorkUnit::Texels);
        if (most == 0) {
            return false;
        }
        std::optional<int> tile = nextBehind(projector, work);
        if (!tile) {
            forget(projector.id()); // captured again, in the next frame: the rest has changed
            return true;
        }
        budget_.start(WorkUnit::Texels);
        AoStatus status;
        int units = 0;
        for (; status && tile && units < most; tile = nextBehind(projector, work)) {
            status = computeBehind(projector, work, *tile);
            ++units;
        }
        budget_.done(units);
        if (!status) {
            return status;
        }
    }
    return true;
}

AoStatus RasterTexels::computeBehind(CubeMapProjector& projector, Work& work, int tile) {
    TileProgress& tiles = projector.tiles;
    const TileProgress::Region region = tiles.region(tile);
    const int pass = tiles.blockPasses(tile) % passes();
    const int layer = 1 + tiles.blockPasses(tile) / passes();
    if (AoStatus status = shading_.accumulateBehind(context_, work.capture, region, layer, pass);
        !status) {
        return status;
    }
    if (pass + 1 == passes()) {
        const auto block = projector.addBlock(store_, blocks_, tile);
        if (!block) {
            tiles.refuseBlock(tile); // it goes without
            return store_.spare() > 0 ? block.status() : AoStatus();
        }
        shading_.resolveBehind(context_, work.capture, projector, blocks_, *block, region, layer);
        projector.showsMore = true;
    }
    tiles.setBlockPasses(tile, tiles.blockPasses(tile) + 1);
    return {};
}

void RasterTexels::keep(const CubeMapProjector& projector, const Work& work, int tile) {
    const TileProgress::Region region = projector.tiles.region(tile);
    if (projector.keeps(region.face)) {
        const float share =
            static_cast<float>(projector.tiles.passes(tile)) / static_cast<float>(passes());
        shading_.resolve(context_, work.capture, projector, store_, region, share);
    }
}

std::size_t RasterTexels::bytes() const {
    std::size_t sum = 0;
    for (const auto& [id, work] : works_) {
        sum += work.capture.bytes();
    }
    return sum;
}

} // namespace aolib
