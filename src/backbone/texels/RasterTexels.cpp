#include "backbone/texels/RasterTexels.h"

#include <algorithm>
#include <utility>

#include "backbone/estimators/Estimators.h"

namespace aolib {

namespace {

/// Passes of every tile before a cube map is shown for the first time.
constexpr int kFirstPasses = 2;

} // namespace

Result<std::unique_ptr<RasterTexels>> RasterTexels::create(const BackboneContext& context,
                                                           const SceneGeometry& geometry,
                                                           TexelAtlas& atlas,
                                                           DeferredShading& shading) {
    auto boxVisibility = BoxVisibilityQuery::create(context);
    if (!boxVisibility) {
        return boxVisibility.status();
    }
    return std::unique_ptr<RasterTexels>(
        new RasterTexels(context, geometry, atlas, shading, std::move(*boxVisibility)));
}

int RasterTexels::passes() const {
    return traitsOf(context_.options.estimator).passes(context_.options);
}

RasterTexels::Work* RasterTexels::find(CubeMapId id) {
    const auto found = works_.find(id);
    return found != works_.end() ? &found->second : nullptr;
}

const RasterTexels::Work* RasterTexels::find(CubeMapId id) const {
    const auto found = works_.find(id);
    return found != works_.end() ? &found->second : nullptr;
}

Result<RasterTexels::Work*> RasterTexels::begin(CubeMapProjector& projector) {
    auto capture = shading_.begin(context_, geometry_, projector);
    if (!capture) {
        return capture.status();
    }
    Work& work = works_[projector.id()];
    work = {};
    work.capture = std::move(*capture);
    work.mayBreak = !brokenOff_.contains(projector.id());
    const TileTable& tiles = projector.tiles();
    for (int tile = 0; tile < tiles.count(); ++tile) { // what was begun went with the last
        const int had = tiles.pagePasses(tile);
        projector.recordPagePasses(tile, had - had % passes());
    }
    return &work;
}

// ---- Changes of the scene -----------------------------------------------------------------------

void RasterTexels::sceneChanged(CubeMapProjector& projector, const Scene::Change& change,
                                float reach) {
    const Bounds region = change.region.inflated(reach);
    // What it holds says nothing of what a capture that has begun sees.
    if (isCapturing(projector.id()) ||
        boxVisibility_.isVisible(context_, projector, atlas_.faces, region)) {
        for (const int tile : projector.tilesTowards(region)) {
            projector.setOutdated(tile);
            framesAtRest_ = 0;
        }
    } else if (atlas_.pages.kind() == PageKind::HiddenLayer) { // of what it does not see
        projector.releasePages(region);
        if (Work* work = find(projector.id())) {
            work->changed.include(region);
        }
    }
}

bool RasterTexels::mayRestart(const CubeMapProjector& projector) const {
    const Work* work = find(projector.id());
    if (work == nullptr || !hasPending(projector)) {
        return true;
    }
    return (work->mayBreak || framesAtRest_ > kRestFrames) && work->capture.ready &&
           projector.tiles().fewestPasses() >= std::min(kFirstPasses, passes());
}

void RasterTexels::restart(CubeMapProjector& projector) {
    const bool breaksOff = works_.contains(projector.id()) && hasPending(projector);
    if (breaksOff) {
        brokenOff_.insert(projector.id());
    } else {
        brokenOff_.erase(projector.id());
    }
    works_.erase(projector.id());
    const TileTable& tiles = projector.tiles();
    for (int tile = 0; tile < tiles.count(); ++tile) {
        // What the last capture has added up of the others is gone with it.
        if (tiles.isOutdated(tile) || tiles.passes(tile) < passes()) {
            projector.releasePages(tile);
            projector.restartTile(tile);
        }
    }
}

bool RasterTexels::hasPending(const CubeMapProjector& projector) const {
    const bool atOnce = context_.options.frameBudget <= 0.0F; // no view has requested pages yet
    return projector.tiles().hasPending(passes()) ||
           (!atOnce && projector.tiles().hasPendingPages(passes())) || !areFinal(projector);
}

bool RasterTexels::areFinal(const CubeMapProjector& projector) const {
    const Work* work = find(projector.id());
    return work == nullptr || work->toKeep.empty();
}

bool RasterTexels::isCapturing(CubeMapId id) const {
    const Work* work = find(id);
    return work != nullptr && !work->capture.ready;
}

std::size_t RasterTexels::bytes() const {
    std::size_t sum = 0;
    for (const auto& [id, work] : works_) {
        sum += work.capture.bytes();
    }
    return sum;
}

// ---- At once ------------------------------------------------------------------------------------

AoStatus RasterTexels::complete(CubeMapProjector& projector) {
    projector.timer().begin();
    const auto work = begin(projector);
    if (!work) {
        return work.status();
    }
    const CubeMapCapture& capture = (*work)->capture;
    while (!capture.ready) {
        if (AoStatus status = shading_.step(context_, (*work)->capture, projector); !status) {
            forget(projector.id());
            return status;
        }
    }
    const int size = atlas_.faces.faceSize();
    for (int face = 0; face < kFaces; ++face) {
        if (projector.hasFace(face)) {
            shading_.accumulate(context_, capture, {face, 0, 0, size, size}, 0, passes());
        }
    }
    for (int face = 0; face < kFaces; ++face) {
        if (projector.hasFace(face)) {
            shading_.resolve(context_, capture, projector, atlas_.faces, {face, 0, 0, size, size},
                             1.0F);
        }
    }
    projector.requestAll();
    for (int tile = 0; tile < projector.tiles().count(); ++tile) {
        projector.recordPasses(tile, passes());
    }
    projector.show();
    projector.timer().end();
    forget(projector.id());
    return {};
}

// ---- Within a budget ----------------------------------------------------------------------------

void RasterTexels::beginFrame(const std::vector<CubeMapProjector*>& projectors) {
    projectors_ = projectors;
    ++framesAtRest_;
    for (auto& [id, work] : works_) {
        ++work.idleFrames;
    }
    std::erase_if(works_, [&](const auto& entry) {
        return entry.second.idleFrames > kIdleFrames &&
               std::ranges::none_of(projectors_, [&](const auto* one) {
                   return one->id() == entry.first && hasPending(*one);
               });
    });
}

CubeMapProjector* RasterTexels::current() const {
    const auto found = std::ranges::find_if(
        projectors_, [&](const CubeMapProjector* one) { return hasPending(*one); });
    return found != projectors_.end() ? *found : nullptr;
}

std::optional<WorkUnit> RasterTexels::next() {
    const CubeMapProjector* projector = current();
    if (projector == nullptr) {
        return std::nullopt;
    }
    const Work* work = find(projector->id());
    if (work == nullptr) {
        return WorkUnit::Prepare;
    }
    if (!work->capture.ready) {
        return work->capture.next();
    }
    return projector->tiles().hasPending(passes()) ? WorkUnit::Texels
           : !work->toKeep.empty()                 ? WorkUnit::Keep
                                                   : WorkUnit::Texels;
}

bool RasterTexels::isReady() {
    const Work* work = find(current()->id());
    return work == nullptr || work->capture.ready || !work->capture.waits();
}

Result<int> RasterTexels::step(int most) {
    CubeMapProjector& projector = *current();
    Work* work = find(projector.id());
    if (work == nullptr) {
        const auto begun = begin(projector);
        if (!begun) {
            return begun.status();
        }
        work = *begun;
    }
    work->idleFrames = 0;
    const auto done = step(projector, *work, most);
    if (!done) {
        forget(projector.id());
    } else if (!projector.isVisible() &&
               projector.tiles().fewestPasses() >= std::min(kFirstPasses, passes())) {
        projector.show();
        if (traitsOf(context_.options.estimator).layered) {
            projector.recordHiddenLayers();
        }
    }
    return done;
}

Result<int> RasterTexels::step(CubeMapProjector& projector, Work& work, int most) {
    if (!work.capture.ready) {
        const AoStatus status = shading_.step(context_, work.capture, projector);
        return status ? Result<int>(1) : Result<int>(status);
    }
    if (projector.tiles().hasPending(passes())) {
        const int units = computeTiles(projector, work, most);
        if (!projector.tiles().hasPending(passes()) &&
            traitsOf(context_.options.estimator).layered) {
            work.toKeep = work.tiles; // once more: the smoothing looks across the borders of tiles
        }
        return units;
    }
    return work.toKeep.empty() ? computeHiddenTiles(projector, work, most)
                               : Result<int>(keepTiles(projector, work, most));
}

int RasterTexels::computeTiles(CubeMapProjector& projector, Work& work, int most) {
    const TileTable& tiles = projector.tiles();
    std::set<int> computed;
    int units = 0;
    while (units < most && tiles.hasPending(passes())) {
        for (const int tile : tiles.mostUrgent(passes())) {
            const TileTable::Region region = tiles.region(tile);
            const int pass = tiles.passes(tile);
            if (!projector.hasFace(region.face)) {
                projector.recordPasses(tile, passes());
                continue;
            }
            shading_.accumulate(context_, work.capture, region, pass, 1);
            projector.recordPasses(tile, pass + 1);
            projector.setAvailablePages(tile, work.capture.geometry->layersOf(region.face) - 1);
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

int RasterTexels::keepTiles(const CubeMapProjector& projector, Work& work, int most) {
    int units = 0;
    for (; units < most && !work.toKeep.empty(); ++units) {
        keep(projector, work, work.toKeep.extract(work.toKeep.begin()).value());
    }
    return units;
}

void RasterTexels::keep(const CubeMapProjector& projector, const Work& work, int tile) {
    const TileTable::Region region = projector.tiles().region(tile);
    if (projector.hasFace(region.face)) {
        const float share =
            static_cast<float>(projector.tiles().passes(tile)) / static_cast<float>(passes());
        shading_.resolve(context_, work.capture, projector, atlas_.faces, region, share);
    }
}

// ---- Surfaces behind others ---------------------------------------------------------------------

std::optional<int> RasterTexels::nextHiddenTile(const CubeMapProjector& projector,
                                                const Work& work) const {
    const TileTable& tiles = projector.tiles();
    std::optional<int> next;
    for (int tile = 0; tile < tiles.count(); ++tile) {
        const bool begun = tiles.pagePasses(tile) % passes() > 0;
        if (tiles.hasPendingPages(tile, passes()) && (begun || !next) &&
            (work.changed.empty() || !projector.looksAt(tile, work.changed))) {
            next = tile;
        }
    }
    return next;
}

Result<int> RasterTexels::computeHiddenTiles(CubeMapProjector& projector, Work& work, int most) {
    std::optional<int> tile = nextHiddenTile(projector, work);
    if (!tile) {
        forget(projector.id()); // captured again: the rest has changed
        return 0;
    }
    int units = 0;
    for (; tile && units < most; tile = nextHiddenTile(projector, work)) {
        if (AoStatus status = computeHiddenTile(projector, work, *tile); !status) {
            return status;
        }
        ++units;
    }
    return units;
}

AoStatus RasterTexels::computeHiddenTile(CubeMapProjector& projector, Work& work, int tile) {
    const TileTable& tiles = projector.tiles();
    const TileTable::Region region = tiles.region(tile);
    const int pass = tiles.pagePasses(tile) % passes();
    const int layer = 1 + tiles.pagePasses(tile) / passes();
    if (AoStatus status = shading_.accumulateHidden(context_, work.capture, region, layer, pass);
        !status) {
        return status;
    }
    if (pass + 1 == passes()) {
        const auto page = projector.addPage(tile);
        if (!page) {
            projector.denyPages(tile);
            return atlas_.faces.freeLayers() > 0 ? page.status() : AoStatus();
        }
        shading_.resolveHidden(context_, work.capture, projector, atlas_.pages, *page, region,
                               layer);
        projector.recordHiddenLayers();
    }
    projector.recordPagePasses(tile, tiles.pagePasses(tile) + 1);
    return {};
}

} // namespace aolib
