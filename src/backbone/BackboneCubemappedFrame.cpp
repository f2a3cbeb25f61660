// A frame with cube maps, from the host's depth to its picture.
#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include "backbone/BackboneCubemapped.h"
#include "backbone/cubemaps/Placement.h"
#include "backbone/estimators/Estimators.h"
#include "backbone/passes/TileRequests.h"
#include "shared/falloff.h"

namespace aolib {

namespace {

/// Where cube maps are placed for a frame, world units.
glm::vec3 standpoint(const FrameContext& context) {
    return Placement::standpoint(context.frame, context.scene.bounds(),
                                 context.options.cubeMaps.faceSize);
}

} // namespace

AoStatus BackboneCubemapped::drawFrame(const FrameContext& context) {
    CubemappedView& view = beginFrame(context);
    if (AoStatus status = updateScene(); !status) {
        return status;
    }
    chooseCubeMaps(context, view);
    applyFeedback(view);
    if (AoStatus status = placeCubeMap(context, view); !status) {
        return status;
    }
    if (AoStatus status = computeTexels(view); !status) {
        return status;
    }
    const AoStatus refined = refineStaticView(context, view);
    if (AoStatus status = drawVisibility(context, view); !status) {
        return status;
    }
    const AoStatus issued = issueFeedback(context, view);
    if (context.options.cubeMaps.outlines) {
        cubeMapPasses_.outlines.draw(context, view.used);
    }
    return issued ? refined : issued; // the picture is complete without either
}

CubemappedView& BackboneCubemapped::beginFrame(const FrameContext& context) {
    CubemappedView& view = currentView();
    schedule_.beginFrame();
    view.beginFrame(context.frame, frameNumber());
    view.projected.clear();
    cubeMaps_.followOptions();
    return view;
}

AoStatus BackboneCubemapped::updateScene() {
    const std::vector<Scene::Change> changes = context_.scene.takeChanges();
    const Options& options = context_.options;
    if (!changes.empty()) { // noted before anything may fail: they will not come again
        // Receivers up to that far away from a change see a difference.
        const float within =
            shared::occluderReach(static_cast<int>(options.falloff), options.radius);
        schedule_.sceneChanged(cubeMaps_.all(), changes, within);
        const bool texels = std::ranges::any_of(cubeMaps_.all(), [](const auto& one) {
            return one->mustBegin() || one->tiles().hasOutdated();
        });
        forEachView([&](CubemappedView& one) { one.sceneChanged(changes, within, texels); });
    }
    if (options.radius != builtRadius_) {
        builtRadius_ = options.radius;
        markAllOutdated();
        restartViews();
    }
    if (traitsOf(options.estimator).needsTracer) {
        sceneGeometry_.forget(changes); // rays need no triangles on the GPU
        return {};
    }
    AoStatus status = sceneGeometry_.update(context_.gl, context_.scene, changes,
                                            traitsOf(options.estimator).layered);
    if (!status) {
        invalidateAll();
    }
    return status;
}

void BackboneCubemapped::chooseCubeMaps(const FrameContext& context, CubemappedView& view) {
    view.used = cubeMaps_.nearest(standpoint(context));
}

void BackboneCubemapped::applyFeedback(CubemappedView& view) {
    auto feedback = view.pendingFeedback.poll();
    if (!feedback) {
        if (view.feedbackInterval() > 1) { // no new feedback: the last usage shares count again
            cubeMaps_.recordUsage(view.feedback.best);
        }
        return;
    }
    cubeMaps_.recordUsage(feedback->best);
    const RequestedTiles requested = requestTiles(view.used, *feedback, cubeMaps_.atlas().pages,
                                                  schedule_.passes(), view.requested);
    view.predictedCoverage = requested.coverage;
    view.missing = requested.missing;
    view.feedback = std::move(*feedback);
    view.feedbackIsCurrent = true;
}

AoStatus BackboneCubemapped::placeCubeMap(const FrameContext& context, CubemappedView& view) {
    cubeMaps_.evictWhereDue(wanted(view), schedule_.atOnce());
    chooseCubeMaps(context, view);
    const std::optional<glm::vec3> position = positionWhereDue(context, view);
    if (position &&
        cubeMaps_.makeRoom(EvictionReason::NewCubeMap, wanted(view), schedule_.atOnce())) {
        if (const auto placed = place(*position, /*pinned=*/false); !placed) {
            return placed.status();
        }
    }
    chooseCubeMaps(context, view);
    return {};
}

std::optional<glm::vec3> BackboneCubemapped::positionWhereDue(const FrameContext& context,
                                                              const CubemappedView& view) const {
    const CubeMapOptions& options = context.options.cubeMaps;
    if (!options.place || context.scene.empty()) {
        return {};
    }
    std::vector<glm::vec3> positions;
    for (const auto& projector : cubeMaps_.all()) {
        positions.push_back(projector->position());
    }
    const float size = context.scene.bounds().diagonal();
    const glm::vec3 at = standpoint(context);
    if (Placement::due(view.predictedCoverage, options.coverage, at, positions, size)) {
        return at;
    }
    if (view.missing && context.frame.camera.orthographic()) {
        const glm::vec3 across = Placement::across(context.frame.camera, at, *view.missing);
        if (Placement::due(view.predictedCoverage, options.coverage, across, positions, size)) {
            return across;
        }
    }
    return {};
}

std::vector<CubeMapProjector*> BackboneCubemapped::wanted(const CubemappedView& view) const {
    std::vector<CubeMapProjector*> list = view.used;
    if (schedule_.atOnce()) {
        return list; // the others in the calls that need them
    }
    forEachView([&](const CubemappedView& other) {
        if (views_.isRecent(other)) {
            std::ranges::copy_if(other.used, std::back_inserter(list), [&](auto* one) {
                return std::ranges::find(list, one) == list.end();
            });
        }
    });
    return list;
}

AoStatus BackboneCubemapped::computeTexels(CubemappedView& view) {
    if (context_.scene.empty()) {
        return {};
    }
    const std::vector<CubeMapProjector*> list = wanted(view);
    for (CubeMapProjector* projector : list) {
        projector->setFrame(frameNumber());
    }
    if (AoStatus status = schedule_.compute(list, budget_); !status) {
        return status;
    }
    if (schedule_.begun() > 0) {
        forEachView([](CubemappedView& one) { one.cubeMapsBegun(); });
    }
    std::ranges::copy_if(view.used, std::back_inserter(view.projected),
                         [](const auto* projector) { return projector->isVisible(); });
    return {};
}

bool BackboneCubemapped::complete(const CubemappedView& view) const {
    const auto isComplete = [&](const CubeMapProjector* one) {
        const auto requested = view.requested.find(one->id());
        return one->isSeenBy(view.feedback.frame) &&
               schedule_.finished(*one, requested != view.requested.end() ? requested->second
                                                                          : TileSet());
    };
    return context_.scene.empty() || ((schedule_.atOnce() || view.hasFeedback()) &&
                                      std::ranges::all_of(view.used, isComplete));
}

AoStatus BackboneCubemapped::refineStaticView(const FrameContext& context, CubemappedView& view) {
    view.texelsComplete = complete(view);
    view.refiner.beginFrame(context.frame,
                            view.projected.empty() ? RefinerKind::None : sources_.refinerKind(),
                            [&] { return sources_.makeRefiner(view.slot); });
    AoStatus status;
    if (view.texelsComplete && view.refiner.isStatic() && !view.refiner.done()) {
        status = view.refiner.advance({context, projected(view)},
                                      schedule_.atOnce() ? nullptr : &budget_);
    }
    const bool before = std::exchange(view.isConverged, view.texelsComplete && view.refiner.done());
    if (view.isConverged && !needsTexture(view)) {
        view.pictures.visibility = {};
    }
    view.convergedIn = view.isConverged && !before ? frameNumber() : view.convergedIn;
    view.noteComputed(view.hasFeedback() || schedule_.atOnce() ? shareComputed(view.used) : 0.0F);
    return status;
}

AoStatus BackboneCubemapped::drawVisibility(const FrameContext& context, CubemappedView& view) {
    const bool buffers = context.options.debugView != DebugView::Off || blurs() ||
                         context.options.cubeMaps.projection != ProjectionMethod::SinglePass;
    if (buffers) {
        if (AoStatus status = computeVisibility(context); !status) {
            return status;
        }
        return passes_.composite.apply(context,
                                       {view.geometry, view.blurred.visibility, *view.latestBest});
    }
    if (!needsTexture(view)) {
        return view.projected.empty()
                   ? AoStatus()
                   : cubeMapPasses_.projection.shade(context, projected(view), view.pictures);
    }
    const auto visibility = cubeMapPasses_.projection.projectToTexture(
        context, projected(view), view.pictures, needsFallback(view));
    if (!visibility) {
        return visibility.status();
    }
    if (needsFallback(view)) {
        cubeMapPasses_.fallback.fillTexture(context, **visibility);
    }
    return passes_.composite.blend(context, **visibility);
}

AoStatus BackboneCubemapped::computeVisibility(const FrameContext& context) {
    CubemappedView& view = currentView();
    if (AoStatus status = passes_.geometry.update(context, view.geometry); !status) {
        return status;
    }
    const auto best = cubeMapPasses_.projection.apply(context, projected(view), view.pictures);
    if (!best) {
        return best.status();
    }
    view.latestBest = *best;
    if (AoStatus status = passes_.blur.apply(context, view.geometry, **best,
                                             blurs() ? context.options.blur.size : 1, view.blurred);
        !status) {
        return status;
    }
    if (needsFallback(view)) {
        cubeMapPasses_.fallback.fill(context, **best, view.blurred.visibility);
    }
    view.buffered = true;
    return {};
}

AoStatus BackboneCubemapped::issueFeedback(const FrameContext& context, CubemappedView& view) {
    ++view.frames;
    if (view.frames % view.feedbackInterval() != 0) {
        return {};
    }
    return cubeMapPasses_.feedback.issue(context, {cubeMaps_.atlas(), view.projected},
                                         frameNumber(), view.pendingFeedback);
}

// ---- What a frame needs to be known
// --------------------------------------------------------------

ProjectedCubeMaps BackboneCubemapped::projected(const CubemappedView& view) const {
    return {cubeMaps_.atlas(), view.projected, view.refiner.refined()};
}

bool BackboneCubemapped::blurs() const {
    return context_.options.blur.enabled && traitsOf(context_.options.estimator).noisy;
}

bool BackboneCubemapped::needsFallback(const CubemappedView& view) const {
    const bool any = !view.projected.empty();
    return ScreenSpaceFallback::due(context_, any ? view.feedback.shaded : 0.0F,
                                    any && schedule_.atOnce());
}

float BackboneCubemapped::shareComputed(const std::vector<CubeMapProjector*>& projectors) const {
    const int pageWeight = cubeMaps_.atlas().pages.scale() * cubeMaps_.atlas().pages.scale();
    TileTable::Share sum;
    for (const CubeMapProjector* projector : projectors) {
        const TileTable::Share share = projector->tiles().share(schedule_.passes(), pageWeight);
        sum.done += share.done;
        sum.needed += share.needed;
    }
    return sum.needed > 0 ? static_cast<float>(sum.done) / static_cast<float>(sum.needed) : 0.0F;
}

std::unique_ptr<ViewState> BackboneCubemapped::makeView() {
    unsigned slot = 0; // the lowest that is free
    const auto taken = [&](const auto& one) {
        return static_cast<const CubemappedView&>(*one).slot == slot;
    };
    while (std::ranges::any_of(views_.all(), taken)) {
        ++slot;
    }
    return std::make_unique<CubemappedView>(slot);
}

void BackboneCubemapped::addStatistics(Statistics& statistics, const ViewState* view) {
    statistics.cubeMapsBuilt = schedule_.begun();
    statistics.cubeMapsEvicted = cubeMaps_.evicted();
    statistics.bytesScene = sceneGeometry_.bytes();
    statistics.bytesKept = cubeMaps_.atlas().faces.bytes();
    statistics.bytesBuilding = sources_.bytes();
    if (view == nullptr) {
        return;
    }
    const auto& of = static_cast<const CubemappedView&>(*view);
    statistics.coverage = of.feedback.shaded;
    statistics.geometryShare = of.feedback.surfaces;
    statistics.coverageFrame = of.feedback.frame;
    statistics.cubeMapsProjected = static_cast<int>(of.projected.size());
    statistics.converged = of.isConverged;
    statistics.pixelsRefined = of.refiner.pixels();
    statistics.computed = of.computed;
}

} // namespace aolib
