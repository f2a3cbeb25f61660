#include "backbone/cubemapped/RasterTexels.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace aolib {

namespace {

/// Passes of every tile before a cube map is shown for the first time.
constexpr int kFirstPasses = 2;
/// How fast a unit's cost follows what is measured.
constexpr double kLearning = 0.5;
/// Most units in a frame, whatever they seem to cost.
constexpr int kMostUnits = 4096;

} // namespace

Result<std::unique_ptr<AbstractTexelSource>> RasterTexels::create(const BackboneContext& context,
                                                                  const SceneGeometry& geometry,
                                                                  FaceStore& store,
                                                                  std::function<float()> radius) {
    std::unique_ptr<RasterTexels> texels(
        new RasterTexels(context, geometry, store, std::move(radius)));
    auto shading = DeferredShading::create(context);
    if (!shading) {
        return shading.status();
    }
    auto timer = gl::GpuTimer::create(context.gl);
    if (!timer) {
        return timer.status();
    }
    texels->shading_ = std::move(*shading);
    texels->timer_ = std::move(*timer);
    return std::unique_ptr<AbstractTexelSource>(std::move(texels));
}

Result<RasterTexels::Work*> RasterTexels::workOf(CubeMapProjector& projector) {
    const auto found = captures_.find(projector.id());
    if (found != captures_.end()) {
        return &found->second;
    }
    auto capture = shading_.capture(context_, geometry_, projector, store_);
    if (!capture) {
        return capture.status();
    }
    Work work;
    work.capture = std::move(*capture);
    return &captures_.emplace(projector.id(), std::move(work)).first->second;
}

Status RasterTexels::complete(CubeMapProjector& projector) {
    const auto start = std::chrono::steady_clock::now();
    projector.timer.begin();
    captures_.erase(projector.id());
    const auto work = workOf(projector);
    if (!work) {
        return work.status();
    }
    const int size = store_.faceSize();
    for (int face = 0; face < kFaces; ++face) {
        if (projector.keeps(face)) {
            shading_.accumulate(context_, (*work)->capture, radius_(), {face, 0, 0, size, size}, 0,
                                passes());
        }
    }
    for (int face = 0; face < kFaces; ++face) {
        if (projector.keeps(face)) {
            shading_.resolve(context_, (*work)->capture, projector, store_,
                             {face, 0, 0, size, size});
        }
    }
    projector.tiles.askAll();
    for (int tile = 0; tile < projector.tiles.count(); ++tile) {
        projector.tiles.setPasses(tile, passes());
    }
    projector.shown = true;
    projector.timer.end();
    captures_.erase(projector.id());
    projector.buildMs =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    return {};
}

int RasterTexels::quota(double milliseconds) {
    if (unitsTimed_ > 0 && !timer_.pending()) {
        const double unit = timer_.milliseconds() / unitsTimed_;
        unitMs_ = unitMs_ < 0.0 ? unit : unitMs_ + kLearning * (unit - unitMs_);
        unitsTimed_ = 0;
    }
    if (unitMs_ < 0.0) {
        return 1;
    }
    const double fits = unitMs_ > 0.0 ? milliseconds / unitMs_ : kMostUnits;
    // At most twice the last: one measurement alone is not trusted with a whole frame.
    lastQuota_ = std::clamp(static_cast<int>(fits), 1, std::min(2 * lastQuota_ + 1, kMostUnits));
    return lastQuota_;
}

Status RasterTexels::advance(const std::vector<CubeMapProjector*>& projectors,
                             double milliseconds) {
    for (auto& [id, work] : captures_) {
        ++work.idleFrames;
    }
    int units = quota(milliseconds);
    const int allowed = units;
    const bool timed = !timer_.pending() && unitsTimed_ == 0;
    for (CubeMapProjector* projector : projectors) {
        if (units <= 0 || !projector->tiles.lacks(passes())) {
            continue;
        }
        if (captures_.find(projector->id()) == captures_.end()) {
            // A capture is a unit of work that fills a frame by itself.
            if (const auto work = workOf(*projector); !work) {
                return work.status();
            }
            break;
        }
        Work& work = captures_.at(projector->id());
        work.idleFrames = 0;
        if (timed && units == allowed) {
            timer_.begin();
        }
        units -= advanceTiles(*projector, work, units);
        resolveTouched(*projector, work);
        projector->shown =
            projector->shown || projector->tiles.fewestPasses() >= std::min(kFirstPasses, passes());
    }
    if (timed && units < allowed) {
        timer_.end();
        unitsTimed_ = allowed - units;
    }
    std::erase_if(captures_,
                  [](const auto& entry) { return entry.second.idleFrames > kIdleFrames; });
    return {};
}

int RasterTexels::advanceTiles(CubeMapProjector& projector, Work& work, int quota) {
    int done = 0;
    TileProgress& tiles = projector.tiles;
    while (done < quota && tiles.lacks(passes())) {
        for (const int tile : tiles.mostUrgent(passes())) {
            const TileProgress::Region region = tiles.region(tile);
            const int pass = tiles.passes(tile);
            if (!projector.keeps(region.face)) {
                tiles.setPasses(tile, passes());
                continue;
            }
            shading_.accumulate(context_, work.capture, radius_(), region, pass, 1);
            tiles.setPasses(tile, pass + 1);
            work.touched.insert(tile);
            work.tiles.insert(tile);
            if (++done >= quota) {
                break;
            }
        }
    }
    return done;
}

void RasterTexels::resolveTouched(CubeMapProjector& projector, Work& work) {
    if (!projector.tiles.lacks(passes())) {
        work.touched = work.tiles; // once more: the smoothing looks across the borders of tiles
    }
    for (const int tile : work.touched) {
        const TileProgress::Region region = projector.tiles.region(tile);
        if (projector.keeps(region.face)) {
            shading_.resolve(context_, work.capture, projector, store_, region);
        }
    }
    work.touched.clear();
}

std::size_t RasterTexels::bytes() const {
    std::size_t sum = 0;
    for (const auto& [id, work] : captures_) {
        sum += work.capture.bytes;
    }
    return sum;
}

} // namespace aolib
