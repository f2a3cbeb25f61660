#include "backbone/cubemapped/BackboneCubemapped.h"

#include <algorithm>
#include <string>
#include <utility>

#include <glm/geometric.hpp>

#include "backbone/Estimators.h"
#include "backbone/cubemapped/Placement.h"
#include "shared/falloff.h"

namespace aolib {

namespace {

template <typename Part>
AoStatus make(std::optional<Part>& part, const BackboneContext& context) {
    Result<Part> created = Part::create(context);
    if (created) {
        part = std::move(*created);
    }
    return created.status();
}

/// Said of what is not prepared, at most.
constexpr float kAlmostPrepared = 0.99F;

AoStatus noScene() {
    return {StatusCode::NoScene,
            "there are no triangles to place a cube map among; describe a mesh first"};
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
        return noScene();
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

AoStatus BackboneCubemapped::beginPreparing(std::span<const glm::vec3> positions) {
    if (context_.scene.empty()) {
        return noScene();
    }
    prepared_ = 0.0F;
    cubeMaps_.followOptions();
    if (AoStatus status = followScene(); !status) {
        return status;
    }
    std::vector<CubeMapProjector*> placed;
    for (const glm::vec3& position : positions) {
        const auto one = placeToPrepare(position);
        if (!one) {
            std::ranges::for_each(placed, [&](auto* added) { cubeMaps_.remove(*added); });
            return one.status();
        }
        if (*one != nullptr) {
            placed.push_back(*one);
        }
    }
    cubeMapsChanged();
    return {};
}

Result<CubeMapProjector*> BackboneCubemapped::placeToPrepare(const glm::vec3& position) {
    const glm::vec3 at = Placement::freePosition(context_.scene, position);
    const auto stands = [&](const auto* one) { return one->position() == at; };
    if (std::ranges::any_of(placedByHand(), stands)) {
        return nullptr;
    }
    if (AoStatus status = cubeMaps_.makeRoomAtOnce(); !status) {
        return status;
    }
    return cubeMaps_.add(at, /*byHand=*/true);
}

std::vector<CubeMapProjector*> BackboneCubemapped::placedByHand() const {
    std::vector<CubeMapProjector*> placed;
    for (const auto& projector : cubeMaps_.all()) {
        if (projector->use.byHand) {
            placed.push_back(projector.get());
        }
    }
    return placed;
}

Result<float> BackboneCubemapped::goOnPreparing(double milliseconds) {
    const std::vector<CubeMapProjector*> placed = placedByHand();
    if (AoStatus status = followScene(); !status) {
        return status;
    }
    const auto complete = schedule_.completeSome(placed, milliseconds);
    if (!complete) {
        return complete.status();
    }
    forEachView([](CubemappedView& one) { one.cubeMapsBegun(); });
    prepared_ = *complete ? 1.0F : std::max(prepared_, kAlmostPrepared * shareComputed(placed));
    return prepared_;
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
    forEachView([&](CubemappedView& one) { one.cubeMapGoes(projector); });
    cubeMapsChanged();
}

void BackboneCubemapped::dropTracer() {
    dropSources();
    schedule_.dropTracer();
    if (context_.options.estimator == Estimator::RayTraced) {
        markAllDirty();
    }
}

// ---- Following the scene and the options --------------------------------------------------------

void BackboneCubemapped::cubeMapsChanged() {
    forEachView([](CubemappedView& one) { one.cubeMapsChanged(); });
}

void BackboneCubemapped::restartViews() {
    forEachView([](CubemappedView& one) { one.restart(); });
}

void BackboneCubemapped::markAllDirty() {
    for (const auto& projector : cubeMaps_.all()) {
        projector->dirty = true;
    }
}

void BackboneCubemapped::markAllOutdated() {
    for (const auto& projector : cubeMaps_.all()) {
        projector->tiles.setAllOutdated();
        projector->outdated = true;
    }
}

void BackboneCubemapped::optionsChanged(const Options& before) {
    if (before.estimator != context_.options.estimator) {
        for (const auto& projector : cubeMaps_.all()) {
            schedule_.forget(projector->id()); // what another source holds
        }
        markAllDirty();
    }
    if (!sameEstimate(before, context_.options)) { // the radius is watched where it is used
        markAllOutdated();
        restartViews();
    }
}

AoStatus BackboneCubemapped::followScene() {
    const std::vector<Scene::Change> changes = context_.scene.takeChanges();
    if (!changes.empty()) { // noted before anything may fail: they will not come again
        // Receivers up to that far away from a change see a difference.
        const float within =
            shared::occluderReach(static_cast<int>(context_.options.falloff), radius());
        schedule_.sceneChanged(cubeMaps_.all(), changes, within);
        const bool texels = std::ranges::any_of(
            cubeMaps_.all(), [](const auto& one) { return one->outdated || one->dirty; });
        forEachView([&](CubemappedView& one) { one.sceneChanged(changes, within, texels); });
    }
    if (const float inForce = radius(); inForce != builtRadius_) {
        builtRadius_ = inForce;
        markAllOutdated();
        restartViews();
    }
    if (context_.options.estimator == Estimator::RayTraced) {
        sceneGeometry_.forget(changes); // rays need no triangles on the GPU
        return {};
    }
    AoStatus status = sceneGeometry_.update(context_.gl, context_.scene, changes,
                                            traitsOf(context_.options.estimator).layered);
    if (!status) {
        markAllDirty();
    }
    return status;
}

} // namespace aolib
