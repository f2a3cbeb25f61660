#include "backbone/cubemapped/BackboneCubemapped.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <glm/geometric.hpp>

#include "backbone/Estimators.h"
#include "backbone/cubemapped/Placement.h"
#include "backbone/cubemapped/TileRequests.h"

namespace aolib {

namespace {

/// From one survey to the next, frames: of a view at rest for which nothing is left to do (the host
/// may draw what it has not described), and of one that moves.
constexpr std::uint64_t kSurveyEveryAtRest = 8;
constexpr std::uint64_t kSurveyEveryMoving = 3;

template <typename Part>
AoStatus make(std::optional<Part>& part, const BackboneContext& context) {
    Result<Part> created = Part::create(context);
    if (created) {
        part = std::move(*created);
    }
    return created.status();
}

AoStatus unknown(CubeMapId id) {
    return {StatusCode::UnknownCubeMap,
            "no cube map has the id " + std::to_string(static_cast<std::uint32_t>(id))};
}

} // namespace

Result<std::unique_ptr<AbstractBackbone>>
BackboneCubemapped::create(const BackboneContext& context) {
    std::unique_ptr<BackboneCubemapped> backbone(new BackboneCubemapped(context));
    AoStatus status = backbone->initialise();
    const auto then = [&](auto& part) {
        if (status) {
            status = make(part, context);
        }
    };
    then(backbone->projection_);
    then(backbone->fallback_);
    then(backbone->survey_);
    then(backbone->sight_);
    then(backbone->outlines_);
    if (status && context.options.estimator != Estimator::RayTraced) {
        status = backbone->schedule_.chooseSource(); // fails here rather than in a frame
    }
    if (!status) {
        return status;
    }
    return std::unique_ptr<AbstractBackbone>(std::move(backbone));
}

// ---- Cube maps by hand --------------------------------------------------------------------------

Result<CubeMapId> BackboneCubemapped::addCubeMap(const glm::vec3& position) {
    if (context_.scene.empty()) {
        return AoStatus(StatusCode::NoScene,
                        "there are no triangles to place a cube map among; describe a mesh first");
    }
    cubeMaps_.followOptions();
    if (AoStatus status = followScene(); !status) {
        return status;
    }
    if (AoStatus status = cubeMaps_.makeRoomAtOnce(); !status) {
        return status;
    }
    return place(position, /*byHand=*/true);
}

Result<CubeMapId> BackboneCubemapped::place(const glm::vec3& position, bool byHand) {
    const auto placed = cubeMaps_.add(position, byHand);
    if (!placed) {
        return placed.status();
    }
    const CubeMapId id = (*placed)->id();
    if (schedule_.atOnce()) {
        if (AoStatus status = schedule_.compute({*placed}); !status) {
            cubeMaps_.remove(**placed);
            return status;
        }
    }
    cubeMapsChanged();
    return id;
}

AoStatus BackboneCubemapped::removeCubeMap(CubeMapId id) {
    CubeMapProjector* projector = cubeMaps_.find(id);
    if (projector == nullptr) {
        return unknown(id);
    }
    cubeMaps_.remove(*projector);
    return {};
}

AoStatus BackboneCubemapped::clear() {
    while (!cubeMaps_.all().empty()) {
        cubeMaps_.remove(*cubeMaps_.all().back());
    }
    return {};
}

std::vector<CubeMapInfo> BackboneCubemapped::cubeMaps() {
    std::vector<CubeMapInfo> infos;
    for (const auto& projector : cubeMaps_.all()) {
        infos.push_back(projector->info(cubeMaps_.store()));
    }
    return infos;
}

Result<CubeMapImage> BackboneCubemapped::readCubeMap(CubeMapId id) {
    const CubeMapProjector* projector = cubeMaps_.find(id);
    if (projector == nullptr) {
        return unknown(id);
    }
    return projector->read(context_.gl, cubeMaps_.store());
}

void BackboneCubemapped::cubeMapGoes(CubeMapProjector& projector) {
    schedule_.forget(projector.id());
    std::erase(projected_, &projector);
    cubeMapsChanged();
}

void BackboneCubemapped::dropTracer() {
    repair_.dropSource();
    schedule_.dropTracer();
    if (context_.options.estimator == Estimator::RayTraced) {
        markAllDirty();
    }
}

// ---- Following the scene and the options --------------------------------------------------------

void BackboneCubemapped::cubeMapsChanged() {
    survey_->restart();
    repair_.lookAgain();
    latestSurvey_.reset();
    coverageToCome_.reset();
}

void BackboneCubemapped::markAllDirty() {
    for (const auto& projector : cubeMaps_.all()) {
        projector->dirty = true;
    }
}

void BackboneCubemapped::optionsChanged(const Options& before) {
    if (before.estimator != context_.options.estimator) {
        for (const auto& projector : cubeMaps_.all()) {
            schedule_.forget(projector->id()); // what another source holds
        }
    }
    if (!sameEstimate(before, context_.options)) { // the radius is watched where it is used
        markAllDirty();
        repair_.restart();
    }
}

AoStatus BackboneCubemapped::followScene() {
    const std::vector<Scene::Change> changes = context_.scene.takeChanges();
    if (!changes.empty()) {
        schedule_.sceneChanged();
        repair_.restart();
    }
    if (context_.options.estimator == Estimator::RayTraced) {
        sceneGeometry_.forget(changes); // rays need no triangles on the GPU
    } else if (AoStatus status =
                   sceneGeometry_.update(context_.gl, context_.scene, changes,
                                         traitsOf(context_.options.estimator).layered);
               !status) {
        markAllDirty(); // the changes are taken and will not come again
        return status;
    }
    const float reach = radius();
    if (reach != builtRadius_) {
        builtRadius_ = reach;
        markAllDirty();
        repair_.restart();
    }
    for (const Scene::Change& change : changes) {
        // Receivers up to a radius away from the change see a difference.
        const Bounds region = change.region.inflated(reach);
        for (const auto& projector : cubeMaps_.all()) {
            // What it keeps does not tell what a capture on its way sees, nor may it begin again
            // with each step of something that moves out of sight. Other meshes, other numbers.
            const bool capturing = schedule_.capturing(projector->id());
            projector->outdated = projector->outdated || capturing;
            projector->dirty = projector->dirty || (capturing && change.geometry) ||
                               sight_->sees(context_, *projector, cubeMaps_.store(), region);
            if (!projector->dirty && cubeMaps_.blocks().scale() == 1) { // of what it does not see
                projector->dropBlocks(cubeMaps_.store(), cubeMaps_.blocks(), region);
                schedule_.changedBehind(*projector, region);
            }
        }
    }
    return {};
}

// ---- Frame --------------------------------------------------------------------------------------

AoStatus BackboneCubemapped::placeWhereDue(const Frame& frame) {
    const CubeMapOptions& options = context_.options.cubeMaps;
    if (!options.place || context_.scene.empty()) {
        return {};
    }
    std::vector<glm::vec3> positions;
    for (const auto& projector : cubeMaps_.all()) {
        positions.push_back(projector->position());
    }
    if (!Placement::due(coverageToCome_, options.coverage, frame.position, positions,
                        context_.scene.bounds().diagonal())) {
        return {};
    }
    return cubeMaps_.makeRoom(Eviction::For::Newcomer, cubeMaps_.nearest(frame.position),
                              schedule_.atOnce())
               ? place(frame.position, /*byHand=*/false).status()
               : AoStatus();
}

void BackboneCubemapped::heedSurvey(const std::vector<CubeMapProjector*>& projectors) {
    const auto answer = survey_->poll();
    if (!answer) {
        if (framesToSurvey() > 1) { // another would have said about the same
            Eviction::follow(cubeMaps_.all(), latestSurvey_->best);
        }
        return;
    }
    latestSurvey_ = answer;
    shownSurvey_ = *answer;
    Eviction::follow(cubeMaps_.all(), answer->best);
    coverageToCome_ = requestTiles(projectors, *answer, cubeMaps_.blocks(), schedule_.passes());
}

AoStatus BackboneCubemapped::prepare(const Frame& frame) {
    schedule_.beginFrame();
    projected_.clear();
    repairStatus_ = {};
    cubeMaps_.followOptions();
    if (AoStatus status = followScene(); !status) {
        return status;
    }
    heedSurvey(cubeMaps_.nearest(frame.position));
    cubeMaps_.evictWhereDue(cubeMaps_.nearest(frame.position), schedule_.atOnce());
    if (AoStatus status = placeWhereDue(frame); !status) {
        return status;
    }
    if (context_.scene.empty()) {
        texelsComplete_ = true;
        repair(frame); // nothing is left to do, nor shown
        return {};
    }
    const std::vector<CubeMapProjector*> used = cubeMaps_.nearest(frame.position);
    for (CubeMapProjector* projector : used) {
        projector->tiles.setFrame(frames_);
    }
    if (AoStatus status = schedule_.compute(used); !status) {
        return status;
    }
    if (schedule_.begun() > 0) {
        repair_.lookAgain();
    }
    texelsComplete_ = true;
    for (CubeMapProjector* projector : used) {
        if (std::exchange(projector->showsMore, false)) {
            projector->surveysBefore = frames_;
        }
        texelsComplete_ =
            texelsComplete_ && schedule_.finished(*projector) &&
            (shownSurvey_.frame > projector->surveysBefore || projector->surveysBefore == 0);
        if (projector->shown) {
            projected_.push_back(projector);
        }
    }
    repair(frame);
    return {};
}

void BackboneCubemapped::repair(const Frame& frame) {
    repair_.follow(frame, projected_.empty() ? nullptr : schedule_.pixels());
    if (texelsComplete_ && repair_.rests() && !repair_.done()) {
        const double budget = schedule_.atOnce() ? HUGE_VAL : double{context_.options.frameBudget};
        const RestingView view{
            .context = context_,
            .frame = frame,
            .host = host_,
            .kept = {cubeMaps_.store(), cubeMaps_.blocks()},
            .projectors = projected_,
            .radius = radius(),
        };
        repairStatus_ = repair_.advance(view, budget);
    }
    const bool before = std::exchange(converged_, texelsComplete_ && repair_.done());
    if (converged_ && !tells()) {
        projection_->dropTold();
    }
    convergedIn_ = converged_ && !before ? frames_ + 1 : convergedIn_;
}

KeptTexels BackboneCubemapped::kept() const {
    return {cubeMaps_.store(), cubeMaps_.blocks(), repair_.repaired()};
}

bool BackboneCubemapped::shadesDirectly() const {
    return context_.options.cubeMaps.projection == ProjectionMethod::SinglePass &&
           !(context_.options.blur.enabled && noisy());
}

bool BackboneCubemapped::noisy() const {
    return context_.options.estimator == Estimator::HorizonSplit;
}

bool BackboneCubemapped::fallsBack() const {
    const bool any = !projected_.empty();
    return Fallback::due(context_, any ? shownSurvey_.shaded : 0.0F, any && schedule_.atOnce());
}

AoStatus BackboneCubemapped::shadeDirectly(const Frame& frame) {
    if (!tells()) {
        return projected_.empty() ? AoStatus()
                                  : projection_->shade(context_, frame, host_, kept(), projected_);
    }
    const auto told = projection_->tell(context_, frame, host_, kept(), projected_, fallsBack());
    if (!told) {
        return told.status();
    }
    if (fallsBack()) {
        fallback_->fillTold(context_, frame, host_, **told, radius());
    }
    return composite_.blend(context_, frame, host_, **told);
}

void BackboneCubemapped::fillIn(const Frame& frame, const gl::RenderToTexture2D& projected,
                                const gl::RenderToTexture2D& visibility) {
    if (fallsBack()) {
        fallback_->fill(context_, frame, host_, projected, radius(), visibility);
    }
}

Result<const gl::RenderToTexture2D*> BackboneCubemapped::computeVisibility(const Frame& frame) {
    return projection_->apply(context_, frame, host_, kept(), projected_);
}

bool BackboneCubemapped::nothingToSurvey() const {
    return converged_ && latestSurvey_ && latestSurvey_->frame >= convergedIn_ &&
           latestSurvey_->frame + repair_.framesAtRest() >= frames_;
}

std::uint64_t BackboneCubemapped::framesToSurvey() const {
    if (nothingToSurvey()) {
        return kSurveyEveryAtRest;
    }
    return latestSurvey_ && !repair_.rests() ? kSurveyEveryMoving : 1;
}

AoStatus BackboneCubemapped::finishFrame(const Frame& frame) {
    ++frames_;
    if (frames_ % framesToSurvey() == 0) {
        survey_->take(context_, frame, host_, {cubeMaps_.store(), cubeMaps_.blocks()}, projected_,
                      frames_);
    }
    if (context_.options.cubeMaps.outlines) {
        outlines_->draw(context_, frame, cubeMaps_.nearest(frame.position));
    }
    return repairStatus_; // the picture is as good as without it
}

void BackboneCubemapped::addStatistics(Statistics& statistics) {
    statistics.coverage = shownSurvey_.shaded;
    statistics.coverageFrame = shownSurvey_.frame;
    statistics.cubeMapsProjected = static_cast<int>(projected_.size());
    statistics.cubeMapsBuilt = schedule_.begun();
    statistics.cubeMapsEvicted = cubeMaps_.evicted();
    statistics.converged = converged_;
    statistics.pixelsRepaired = repair_.pixels();
    const int blockWeight = cubeMaps_.blocks().scale() * cubeMaps_.blocks().scale();
    TileProgress::Share sum;
    for (const CubeMapProjector* projector : projected_) {
        const TileProgress::Share share = projector->tiles.share(schedule_.passes(), blockWeight);
        sum.done += share.done;
        sum.needed += share.needed;
    }
    statistics.computed = sum.needed > 0
                              ? static_cast<float>(sum.done) / static_cast<float>(sum.needed)
                              : statistics.computed;
    statistics.bytesFrame += projection_->bytes() + repair_.bytes();
    statistics.bytesScene = sceneGeometry_.bytes();
    statistics.bytesKept = cubeMaps_.store().bytes();
    statistics.bytesBuilding = schedule_.bytes();
}

} // namespace aolib
