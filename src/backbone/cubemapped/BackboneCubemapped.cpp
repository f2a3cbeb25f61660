#include "backbone/cubemapped/BackboneCubemapped.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <glm/geometric.hpp>

#include "backbone/Estimators.h"
#include "backbone/cubemapped/Placement.h"
#include "shared/cube_faces.h"

namespace aolib {

namespace {

/// Texels this many times as wide as the pixels that show them are too coarse for edges.
constexpr float kCoarse = 1.25F;

template <typename Part>
Status make(std::optional<Part>& part, const BackboneContext& context) {
    Result<Part> created = Part::create(context);
    if (created) {
        part = std::move(*created);
    }
    return created.status();
}

Status unknown(CubeMapId id) {
    return {StatusCode::UnknownCubeMap,
            "no cube map has the id " + std::to_string(static_cast<std::uint32_t>(id))};
}

} // namespace

Result<std::unique_ptr<AbstractBackbone>>
BackboneCubemapped::create(const BackboneContext& context) {
    std::unique_ptr<BackboneCubemapped> backbone(new BackboneCubemapped(context));
    Status status = backbone->initialise();
    const auto then = [&](auto& part) {
        if (status) {
            status = make(part, context);
        }
    };
    then(backbone->projection_);
    then(backbone->survey_);
    then(backbone->sight_);
    then(backbone->repair_);
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
        return Status(StatusCode::NoScene,
                      "there are no triangles to place a cube map among; describe a mesh first");
    }
    followStore();
    if (Status status = followScene(); !status) {
        return status;
    }
    while (store_.spare() < kFaces) {
        const auto* victim = Eviction::victim(projectors_, {}, Eviction::For::Newcomer);
        if (victim == nullptr) {
            return Status(
                StatusCode::OutOfMemory,
                "the " + std::to_string(projectors_.size()) +
                    " cube maps placed by hand leave no room for another within "
                    "Options::cubeMaps.memoryBudget or the texture layers of this context");
        }
        evict(*victim);
    }
    return place(position, /*byHand=*/true);
}

Result<CubeMapId> BackboneCubemapped::place(const glm::vec3& position, bool byHand) {
    auto projector = CubeMapProjector::create(context_.gl, CubeMapId{nextId_},
                                              Placement::freePosition(context_.scene, position),
                                              store_.faceSize());
    if (!projector) {
        return projector.status();
    }
    store_.reserve();
    projectors_.push_back(std::make_unique<CubeMapProjector>(std::move(*projector)));
    CubeMapProjector& placed = *projectors_.back();
    placed.use.byHand = byHand;
    if (schedule_.atOnce()) {
        if (Status status = schedule_.compute({&placed}); !status) {
            removeCubeMap(placed.id());
            return status;
        }
    }
    cubeMapsChanged();
    return CubeMapId{nextId_++};
}

Status BackboneCubemapped::removeCubeMap(CubeMapId id) {
    const auto found = find(id);
    if (found == projectors_.end()) {
        return unknown(id);
    }
    schedule_.forget(id);
    (*found)->dropDetails(store_, details_);
    (*found)->dropFaces(store_);
    store_.release();
    std::erase(projected_, found->get());
    projectors_.erase(found);
    for (const auto& projector : projectors_) {
        projector->tiles.allowDetail(); // there may be room for it now
    }
    cubeMapsChanged();
    return {};
}

Status BackboneCubemapped::clear() {
    while (!projectors_.empty()) {
        removeCubeMap(projectors_.back()->id());
    }
    return {};
}

std::vector<CubeMapInfo> BackboneCubemapped::cubeMaps() {
    std::vector<CubeMapInfo> infos;
    for (const auto& projector : projectors_) {
        infos.push_back(projector->info(store_));
    }
    return infos;
}

Result<CubeMapImage> BackboneCubemapped::readCubeMap(CubeMapId id) {
    const auto found = find(id);
    if (found == projectors_.end()) {
        return unknown(id);
    }
    return (*found)->read(context_.gl, store_);
}

void BackboneCubemapped::dropTracer() {
    schedule_.dropTracer();
    repair_->restart();
    if (context_.options.estimator == Estimator::RayTraced) {
        markAllDirty();
    }
}

std::vector<std::unique_ptr<CubeMapProjector>>::iterator BackboneCubemapped::find(CubeMapId id) {
    return std::find_if(projectors_.begin(), projectors_.end(),
                        [&](const auto& projector) { return projector->id() == id; });
}

// ---- Following the scene and the options --------------------------------------------------------

void BackboneCubemapped::cubeMapsChanged() {
    survey_->restart();
    repair_->lookAgain();
    latestSurvey_.reset();
}

void BackboneCubemapped::markAllDirty() {
    for (const auto& projector : projectors_) {
        projector->dirty = true;
    }
}

void BackboneCubemapped::optionsChanged(const Options& before) {
    if (before.estimator != context_.options.estimator) {
        for (const auto& projector : projectors_) {
            schedule_.forget(projector->id()); // what another source holds
        }
    }
    if (!sameEstimate(before, context_.options)) { // the radius is watched where it is used
        markAllDirty();
        repair_->restart();
    }
}

void BackboneCubemapped::followStore() {
    const CubeMapOptions& options = context_.options.cubeMaps;
    const int limit = Eviction::layersWithin(options, context_.gl.capabilities.maxTextureLayers);
    if (store_.faceSize() != options.faceSize || limit < store_.layers()) {
        for (const auto& projector : projectors_) {
            schedule_.forget(projector->id());
            projector->dropDetails(store_, details_);
            projector->dropFaces(store_);
            projector->tiles = TileProgress(options.faceSize);
            projector->dirty = true;
            projector->shown = false;
        }
        store_.reset(options.faceSize);
    }
    if (limit > store_.limit()) {
        for (const auto& projector : projectors_) {
            projector->tiles.allowDetail();
        }
    }
    store_.setLimit(limit);
    while (store_.spare() < 0) {
        evict(*Eviction::victim(projectors_, {}, Eviction::For::Budget));
    }
}

Status BackboneCubemapped::followScene() {
    const std::vector<Scene::Change> changes = context_.scene.takeChanges();
    if (context_.options.estimator == Estimator::RayTraced) {
        sceneGeometry_.forget(changes); // rays need no triangles on the GPU
    } else if (Status status = sceneGeometry_.update(context_.gl, context_.scene, changes,
                                                     traitsOf(context_.options.estimator).layered);
               !status) {
        markAllDirty(); // the changes are taken and will not come again
        return status;
    }
    if (!changes.empty()) {
        schedule_.sceneChanged();
        repair_->restart();
    }
    const float reach = radius();
    if (reach != builtRadius_) {
        builtRadius_ = reach;
        markAllDirty();
        repair_->restart();
    }
    for (const Scene::Change& change : changes) {
        // Receivers up to a radius away from the change see a difference.
        const Bounds region = change.region.inflated(reach);
        for (const auto& projector : projectors_) {
            // What it keeps does not tell what a capture on its way sees, nor may it begin again
            // with each step of something that moves out of sight. Other meshes, other numbers.
            const bool capturing = schedule_.capturing(projector->id());
            projector->outdated = projector->outdated || capturing;
            projector->dirty = projector->dirty || (capturing && change.geometry) ||
                               sight_->sees(context_, *projector, store_, region);
        }
    }
    return {};
}

// ---- Frame --------------------------------------------------------------------------------------

Status BackboneCubemapped::placeWhereDue(const Frame& frame) {
    const CubeMapOptions& options = context_.options.cubeMaps;
    if (!options.place || context_.scene.empty()) {
        return {};
    }
    std::vector<glm::vec3> positions;
    for (const auto& projector : projectors_) {
        positions.push_back(projector->position());
    }
    std::optional<float> coverage;
    if (latestSurvey_ && texelsComplete_) { // one that is on its way may cover what is missing
        coverage = latestSurvey_->shaded;
    }
    if (!Placement::due(coverage, options.coverage, frame.position, positions,
                        context_.scene.bounds().diagonal())) {
        return {};
    }
    return makeRoom(Eviction::For::Newcomer, frame) ? place(frame.position, false).status()
                                                    : Status();
}

bool BackboneCubemapped::makeRoom(Eviction::For reason, const Frame& frame) {
    const std::vector<CubeMapProjector*> used = nearest(frame.position);
    while (store_.spare() < (reason == Eviction::For::Newcomer ? kFaces : 1)) {
        CubeMapProjector* victim = Eviction::victim(projectors_, used, reason);
        if (victim == nullptr) {
            return false;
        }
        const bool inView =
            victim->shown && std::find(used.begin(), used.end(), victim) != used.end();
        if (inView && !schedule_.atOnce()) {
            victim->use.retiring = true;
            return false;
        }
        evict(*victim);
    }
    return true;
}

void BackboneCubemapped::evictWhereDue(const Frame& frame) {
    const std::vector<CubeMapProjector*> used = nearest(frame.position);
    const auto gone = [&](const auto& projector) {
        return projector->use.retiring &&
               (projector->bias <= CubeMapProjector::kNewcomer || schedule_.atOnce() ||
                std::find(used.begin(), used.end(), projector.get()) == used.end());
    };
    for (auto found = std::find_if(projectors_.begin(), projectors_.end(), gone);
         found != projectors_.end();
         found = std::find_if(projectors_.begin(), projectors_.end(), gone)) {
        evict(**found);
    }
    const bool refused = std::any_of(projectors_.begin(), projectors_.end(), [](const auto& one) {
        return one->use.surveysUnseen == 0 && one->tiles.refusedDetail();
    });
    if (refused && makeRoom(Eviction::For::Detail, frame)) {
        for (const auto& projector : projectors_) {
            projector->tiles.allowDetail();
        }
    }
}

void BackboneCubemapped::evict(const CubeMapProjector& projector) {
    ++evicted_;
    removeCubeMap(projector.id());
}

std::vector<CubeMapProjector*> BackboneCubemapped::nearest(const glm::vec3& camera) const {
    std::vector<CubeMapProjector*> chosen;
    for (const auto& projector : projectors_) {
        chosen.push_back(projector.get());
    }
    std::stable_sort(chosen.begin(), chosen.end(), [&](const auto* a, const auto* b) {
        return glm::distance(a->position(), camera) < glm::distance(b->position(), camera);
    });
    const auto limit = static_cast<std::size_t>(context_.options.cubeMaps.nearest);
    chosen.resize(std::min(chosen.size(), limit));
    return chosen;
}

void BackboneCubemapped::heedSurvey(const std::vector<CubeMapProjector*>& projectors) {
    const auto answer = survey_->poll();
    if (!answer) {
        return;
    }
    latestSurvey_ = answer;
    shownSurvey_ = *answer;
    Eviction::follow(projectors_, answer->best);
    for (CubeMapProjector* projector : projectors) {
        const glm::vec3 toEye(answer->eye - glm::dvec3(projector->position()));
        const auto size = static_cast<float>(projector->tiles.faceSize());
        for (std::size_t i = 0; i < answer->points.size(); ++i) {
            const glm::vec3 p = toEye + answer->points[i];
            const int face = shared::faceOf(p);
            const glm::vec2 at = shared::faceCoordinates(face, p) * size;
            projector->tiles.ask(face, at);
            const float texel = 2.0F * glm::dot(p, shared::faceForward(face)) / size;
            if (texel > kCoarse * answer->footprints[i]) {
                projector->tiles.askFine(face, at);
            }
        }
    }
}

Status BackboneCubemapped::prepare(const Frame& frame) {
    schedule_.beginFrame();
    projected_.clear();
    followStore();
    if (Status status = followScene(); !status) {
        return status;
    }
    heedSurvey(nearest(frame.position));
    evictWhereDue(frame);
    if (Status status = placeWhereDue(frame); !status) {
        return status;
    }
    if (context_.scene.empty()) {
        return {};
    }
    const std::vector<CubeMapProjector*> used = nearest(frame.position);
    if (Status status = schedule_.compute(used); !status) {
        return status;
    }
    if (schedule_.begun() > 0) {
        repair_->lookAgain();
    }
    texelsComplete_ = true;
    for (CubeMapProjector* projector : used) {
        texelsComplete_ = texelsComplete_ && schedule_.finished(*projector);
        if (projector->shown) {
            projected_.push_back(projector);
        }
    }
    return repair(frame);
}

Status BackboneCubemapped::repair(const Frame& frame) {
    repair_->follow(frame);
    TracerQueue* tracer = schedule_.tracer();
    if (tracer == nullptr || projected_.empty()) {
        repair_->restart();
        converged_ = texelsComplete_;
        return {};
    }
    if (!repair_->tracing()) {
        tracer->drop(TracerQueue::Asker::Pixels); // the view has moved
    }
    Status status;
    if (texelsComplete_ && repair_->rests() && !repair_->done()) {
        const double budget = schedule_.atOnce() ? HUGE_VAL : double{context_.options.frameBudget};
        status = repair_->advance(context_, frame, host_, {store_, details_}, projected_, *tracer,
                                  radius(), budget);
    }
    converged_ = texelsComplete_ && repair_->done();
    return status;
}

KeptTexels BackboneCubemapped::kept() const {
    return {store_, details_, repair_->repaired()};
}

bool BackboneCubemapped::shadesDirectly() const {
    return context_.options.cubeMaps.projection == ProjectionMethod::SinglePass &&
           !(context_.options.blur.enabled && noisy());
}

bool BackboneCubemapped::noisy() const {
    return context_.options.estimator == Estimator::HorizonSplit;
}

void BackboneCubemapped::shadeDirectly(const Frame& frame) {
    if (!projected_.empty()) {
        projection_->shade(context_, frame, host_, kept(), projected_);
    }
}

Result<const gl::RenderToTexture2D*> BackboneCubemapped::computeVisibility(const Frame& frame) {
    return projection_->apply(context_, frame, host_, kept(), projected_);
}

Status BackboneCubemapped::finishFrame(const Frame& frame) {
    survey_->take(context_, frame, host_, {store_, details_}, projected_, ++framesSurveyed_);
    if (context_.options.cubeMaps.outlines) {
        outlines_->draw(context_, frame, nearest(frame.position));
    }
    return {};
}

void BackboneCubemapped::addStatistics(Statistics& statistics) {
    statistics.coverage = shownSurvey_.shaded;
    statistics.coverageFrame = shownSurvey_.frame;
    statistics.cubeMapsProjected = static_cast<int>(projected_.size());
    statistics.cubeMapsBuilt = schedule_.begun();
    statistics.cubeMapsEvicted = evicted_;
    statistics.converged = converged_;
    statistics.pixelsTraced = repair_->pixels();
    TileProgress::Share sum;
    for (const CubeMapProjector* projector : projected_) {
        const TileProgress::Share share = projector->tiles.share(schedule_.passes());
        sum.done += share.done;
        sum.needed += share.needed;
    }
    statistics.computed = sum.needed > 0
                              ? static_cast<float>(sum.done) / static_cast<float>(sum.needed)
                              : statistics.computed;
    statistics.bytesFrame += projection_->bytes() + repair_->bytes();
    statistics.bytesScene = sceneGeometry_.bytes();
    statistics.bytesKept = store_.bytes();
    statistics.bytesBuilding = schedule_.bytes();
}

} // namespace aolib
