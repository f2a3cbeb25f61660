#include "backbone/BackboneCubemapped.h"

#include <algorithm>
#include <string>
#include <utility>

#include "backbone/cubemaps/Placement.h"
#include "backbone/estimators/Estimators.h"

namespace aolib {

namespace {

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

Result<CubeMapPasses> CubeMapPasses::create(const BackboneContext& context) {
    auto projection = Projection::create(context);
    if (!projection) {
        return projection.status();
    }
    auto fallback = ScreenSpaceFallback::create(context);
    if (!fallback) {
        return fallback.status();
    }
    auto feedback = FeedbackPass::create(context);
    if (!feedback) {
        return feedback.status();
    }
    auto outlines = CubeMapOutlines::create(context);
    if (!outlines) {
        return outlines.status();
    }
    return CubeMapPasses{std::move(*projection), std::move(*fallback), std::move(*feedback),
                         std::move(*outlines)};
}

BackboneCubemapped::BackboneCubemapped(const BackboneContext& context, FramePasses passes,
                                       CubeMapPasses cubeMapPasses, FrameBudget budget)
    : AbstractBackbone(context, std::move(passes)), cubeMapPasses_(std::move(cubeMapPasses)),
      cubeMaps_(context, [this](CubeMapProjector& one) { beforeRemoval(one); }),
      sources_(context, sceneGeometry_, cubeMaps_.atlas()), schedule_(context, sources_),
      budget_(std::move(budget)) {}

Result<std::unique_ptr<AbstractBackbone>>
BackboneCubemapped::create(const BackboneContext& context) {
    auto passes = FramePasses::create(context);
    if (!passes) {
        return passes.status();
    }
    auto cubeMapPasses = CubeMapPasses::create(context);
    if (!cubeMapPasses) {
        return cubeMapPasses.status();
    }
    auto budget = FrameBudget::create(context.gl);
    if (!budget) {
        return budget.status();
    }
    std::unique_ptr<BackboneCubemapped> backbone(new BackboneCubemapped(
        context, std::move(*passes), std::move(*cubeMapPasses), std::move(*budget)));
    if (!traitsOf(context.options.estimator).needsTracer) { // fails here rather than in a frame
        if (AoStatus status = backbone->sources_.choose(); !status) {
            return status;
        }
    }
    return std::unique_ptr<AbstractBackbone>(std::move(backbone));
}

// ---- Cube maps ---------------------------------------------------------------------------------

Result<CubeMapId> BackboneCubemapped::addCubeMap(const glm::vec3& position) {
    if (context_.scene.empty()) {
        return noScene();
    }
    cubeMaps_.followOptions();
    if (AoStatus status = updateScene(); !status) {
        return status;
    }
    if (AoStatus status = cubeMaps_.makeRoomAtOnce(); !status) {
        return status;
    }
    return place(position, /*pinned=*/true);
}

Result<CubeMapId> BackboneCubemapped::place(const glm::vec3& position, bool pinned) {
    const auto placed = cubeMaps_.add(position, pinned);
    if (!placed) {
        return placed.status();
    }
    const CubeMapId id = (*placed)->id();
    if (schedule_.atOnce()) {
        if (AoStatus status = schedule_.compute({*placed}, budget_); !status) {
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
    if (AoStatus status = updateScene(); !status) {
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
    if (std::ranges::any_of(pinned(), stands)) {
        return nullptr;
    }
    if (AoStatus status = cubeMaps_.makeRoomAtOnce(); !status) {
        return status;
    }
    return cubeMaps_.add(at, /*pinned=*/true);
}

std::vector<CubeMapProjector*> BackboneCubemapped::pinned() const {
    std::vector<CubeMapProjector*> placed;
    for (const auto& projector : cubeMaps_.all()) {
        if (projector->isPinned()) {
            placed.push_back(projector.get());
        }
    }
    return placed;
}

Result<float> BackboneCubemapped::goOnPreparing(double milliseconds) {
    const std::vector<CubeMapProjector*> placed = pinned();
    if (AoStatus status = updateScene(); !status) {
        return status;
    }
    const auto complete = schedule_.completeSome(placed, budget_, milliseconds);
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

void BackboneCubemapped::clear() {
    while (!cubeMaps_.all().empty()) {
        cubeMaps_.remove(*cubeMaps_.all().back());
    }
}

std::vector<CubeMapInfo> BackboneCubemapped::cubeMaps() {
    std::vector<CubeMapInfo> infos;
    for (const auto& projector : cubeMaps_.all()) {
        infos.push_back(projector->info());
    }
    return infos;
}

Result<CubeMapImage> BackboneCubemapped::readCubeMap(CubeMapId id) {
    const CubeMapProjector* projector = cubeMaps_.find(id);
    if (projector == nullptr) {
        return unknown(id);
    }
    return projector->read(context_.gl);
}

void BackboneCubemapped::beforeRemoval(CubeMapProjector& projector) {
    sources_.forget(projector.id());
    forEachView([&](CubemappedView& one) { one.forgetCubeMap(projector); });
    cubeMapsChanged();
}

void BackboneCubemapped::dropTracer() {
    dropRefiners();
    sources_.dropTracer();
    if (traitsOf(context_.options.estimator).needsTracer) {
        invalidateAll();
    }
}

// ---- Following the scene and the options --------------------------------------------------------

void BackboneCubemapped::cubeMapsChanged() {
    forEachView([](CubemappedView& one) { one.cubeMapsChanged(); });
}

void BackboneCubemapped::restartViews() {
    forEachView([](CubemappedView& one) { one.restart(); });
}

void BackboneCubemapped::invalidateAll() {
    for (const auto& projector : cubeMaps_.all()) {
        projector->invalidate();
    }
}

void BackboneCubemapped::markAllOutdated() {
    for (const auto& projector : cubeMaps_.all()) {
        projector->setAllOutdated();
    }
}

void BackboneCubemapped::optionsChanged(const Options& before) {
    if (before.estimator != context_.options.estimator) {
        for (const auto& projector : cubeMaps_.all()) {
            sources_.forget(projector->id()); // what another source holds
        }
        invalidateAll();
    }
    if (!sameEstimate(before, context_.options)) { // the radius is watched where it is used
        markAllOutdated();
        restartViews();
    }
}

} // namespace aolib
