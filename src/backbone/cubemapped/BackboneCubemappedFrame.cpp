// A frame of the strategy: what BackboneCubemapped does between the host's depth and its picture.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "backbone/Estimators.h"
#include "backbone/cubemapped/BackboneCubemapped.h"
#include "backbone/cubemapped/Placement.h"
#include "backbone/cubemapped/TileRequests.h"
#include "shared/falloff.h"

namespace aolib {

glm::vec3 BackboneCubemapped::standpoint(const Frame& frame) const {
    return Placement::standpoint(frame, context_.scene.bounds(),
                                 context_.options.cubeMaps.faceSize);
}

AoStatus BackboneCubemapped::placeWhereDue(const Frame& frame) {
    const CubeMapOptions& options = context_.options.cubeMaps;
    if (!options.place || context_.scene.empty()) {
        return {};
    }
    std::vector<glm::vec3> positions;
    for (const auto& projector : cubeMaps_.all()) {
        positions.push_back(projector->position());
    }
    const CubemappedView& of = seen();
    const float size = context_.scene.bounds().diagonal();
    glm::vec3 at = standpoint(frame);
    bool due = Placement::due(of.coverageToCome, options.coverage, at, positions, size);
    if (!due && of.missing && frame.camera.orthographic()) {
        at = Placement::across(frame.camera, at, *of.missing);
        due = Placement::due(of.coverageToCome, options.coverage, at, positions, size);
    }
    if (!due) {
        return {};
    }
    return cubeMaps_.makeRoom(Eviction::For::Newcomer, wanted(), schedule_.atOnce())
               ? place(at, /*byHand=*/false).status()
               : AoStatus();
}

void BackboneCubemapped::heedSurvey(CubemappedView& of) {
    auto answer = of.surveys.poll();
    if (!answer) {
        if (of.framesToSurvey() > 1) { // another would have said about the same
            Eviction::follow(cubeMaps_.all(), of.latestSurvey->best);
        }
        return;
    }
    Eviction::follow(cubeMaps_.all(), answer->best);
    const RequestedTiles requested =
        requestTiles(of.used, *answer, cubeMaps_.blocks(), schedule_.passes(), of.asked);
    of.coverageToCome = requested.coverage;
    of.missing = requested.missing;
    of.shownSurvey = *answer;
    of.latestSurvey = std::move(answer);
}

std::vector<CubeMapProjector*> BackboneCubemapped::wanted() const {
    std::vector<CubeMapProjector*> list = seen().used;
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

AoStatus BackboneCubemapped::prepare(const Frame& frame) {
    CubemappedView& of = seen();
    schedule_.beginFrame();
    of.follow(frame, frames_ + 1);
    of.projected.clear();
    of.repairStatus = {};
    cubeMaps_.followOptions();
    if (AoStatus status = followScene(); !status) {
        return status;
    }
    const glm::vec3 from = standpoint(frame);
    of.used = cubeMaps_.nearest(from);
    heedSurvey(of);
    cubeMaps_.evictWhereDue(wanted(), schedule_.atOnce());
    of.used = cubeMaps_.nearest(from);
    if (AoStatus status = placeWhereDue(frame); !status) {
        return status;
    }
    if (!context_.scene.empty()) {
        of.used = cubeMaps_.nearest(from);
        if (AoStatus status = computeTexels(of); !status) {
            return status;
        }
    }
    repair(frame); // in an empty scene nothing is left to do, nor shown
    return {};
}

AoStatus BackboneCubemapped::computeTexels(CubemappedView& of) {
    const std::vector<CubeMapProjector*> list = wanted();
    for (CubeMapProjector* projector : list) {
        projector->tiles.setFrame(frames_);
    }
    if (AoStatus status = schedule_.compute(list); !status) {
        return status;
    }
    if (schedule_.begun() > 0) {
        forEachView([](CubemappedView& one) { one.cubeMapsBegun(); });
    }
    std::ranges::copy_if(of.used, std::back_inserter(of.projected),
                         [](const auto* projector) { return projector->shown; });
    return {};
}

bool BackboneCubemapped::complete(CubemappedView& of) {
    if (context_.scene.empty()) {
        return true;
    }
    bool complete = schedule_.atOnce() || of.surveyed();
    for (CubeMapProjector* projector : of.used) {
        if (std::exchange(projector->showsMore, false)) {
            projector->surveysBefore = frames_;
        }
        complete =
            complete && schedule_.finished(*projector, of.asked[projector->id()]) &&
            (of.shownSurvey.frame > projector->surveysBefore || projector->surveysBefore == 0);
    }
    return complete;
}

void BackboneCubemapped::repair(const Frame& frame) {
    CubemappedView& of = seen();
    of.texelsComplete = complete(of);
    of.repair.follow(frame, of.projected.empty() ? PixelSources::Kind::None : schedule_.pixels(),
                     [&] { return schedule_.makePixels(of.slot); });
    if (of.texelsComplete && of.repair.rests() && !of.repair.done()) {
        const double budget = schedule_.atOnce() ? HUGE_VAL : double{context_.options.frameBudget};
        const RestingView resting{
            .context = context_,
            .frame = frame,
            .host = of.host,
            .kept = {.faces = cubeMaps_.store(), .blocks = cubeMaps_.blocks(), .reach = reach()},
            .projectors = of.projected,
            .radius = radius(),
        };
        of.repairStatus = of.repair.advance(resting, budget);
    }
    const bool before = std::exchange(of.isConverged, of.texelsComplete && of.repair.done());
    if (of.isConverged && !tells()) {
        of.pictures.told = {};
    }
    of.convergedIn = of.isConverged && !before ? frames_ + 1 : of.convergedIn;
    of.noteComputed(of.surveyed() || schedule_.atOnce() ? shareComputed(of.used) : 0.0F);
}

float BackboneCubemapped::shareComputed(const std::vector<CubeMapProjector*>& projectors) const {
    const int blockWeight = cubeMaps_.blocks().scale() * cubeMaps_.blocks().scale();
    TileProgress::Share sum;
    for (const CubeMapProjector* projector : projectors) {
        const TileProgress::Share share = projector->tiles.share(schedule_.passes(), blockWeight);
        sum.done += share.done;
        sum.needed += share.needed;
    }
    return sum.needed > 0 ? static_cast<float>(sum.done) / static_cast<float>(sum.needed) : 0.0F;
}

float BackboneCubemapped::reach() {
    return context_.options.falloff == Falloff::Off ? shared::kEndless : radius();
}

KeptTexels BackboneCubemapped::kept() {
    return {cubeMaps_.store(), cubeMaps_.blocks(), reach(), seen().repair.repaired()};
}

bool BackboneCubemapped::shadesDirectly() const {
    return context_.options.cubeMaps.projection == ProjectionMethod::SinglePass &&
           !(context_.options.blur.enabled && noisy());
}

bool BackboneCubemapped::noisy() const {
    return context_.options.estimator == Estimator::HorizonSplit;
}

bool BackboneCubemapped::fallsBack() const {
    const CubemappedView& of = seen();
    const bool any = !of.projected.empty();
    return Fallback::due(context_, any ? of.shownSurvey.shaded : 0.0F, any && schedule_.atOnce());
}

AoStatus BackboneCubemapped::shadeDirectly(const Frame& frame) {
    CubemappedView& of = seen();
    if (!tells()) {
        return of.projected.empty() ? AoStatus()
                                    : projection_->shade(context_, frame, of.host, kept(),
                                                         of.projected, of.pictures);
    }
    const auto told =
        projection_->tell(context_, frame, of.host, kept(), of.projected, of.pictures, fallsBack());
    if (!told) {
        return told.status();
    }
    if (fallsBack()) {
        fallback_->fillTold(context_, frame, of.host, **told, radius());
    }
    return composite_.blend(context_, frame, of.host, **told);
}

void BackboneCubemapped::fillIn(const Frame& frame, const gl::RenderToTexture2D& projected,
                                const gl::RenderToTexture2D& visibility) {
    if (fallsBack()) {
        fallback_->fill(context_, frame, seen().host, projected, radius(), visibility);
    }
}

Result<const gl::RenderToTexture2D*> BackboneCubemapped::computeVisibility(const Frame& frame) {
    CubemappedView& of = seen();
    return projection_->apply(context_, frame, of.host, kept(), of.projected, of.pictures);
}

AoStatus BackboneCubemapped::finishFrame(const Frame& frame) {
    CubemappedView& of = seen();
    ++frames_;
    ++of.frames;
    AoStatus status;
    if (of.frames % of.framesToSurvey() == 0) {
        status = survey_->take(context_, frame, of.host,
                               {cubeMaps_.store(), cubeMaps_.blocks(), reach()}, of.projected,
                               frames_, of.surveys);
    }
    if (context_.options.cubeMaps.outlines) {
        outlines_->draw(context_, frame, of.used);
    }
    return status ? of.repairStatus : status; // the picture is as good as without it
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
    statistics.bytesKept = cubeMaps_.store().bytes();
    statistics.bytesBuilding = schedule_.bytes();
    if (view == nullptr) {
        return;
    }
    const auto& of = static_cast<const CubemappedView&>(*view);
    statistics.coverage = of.shownSurvey.shaded;
    statistics.geometryShare = of.shownSurvey.surfaces;
    statistics.coverageFrame = of.shownSurvey.frame;
    statistics.cubeMapsProjected = static_cast<int>(of.projected.size());
    statistics.converged = of.isConverged;
    statistics.pixelsRepaired = of.repair.pixels();
    statistics.computed = of.computed;
}

} // namespace aolib
