#include "backbone/cubemapped/BackboneCubemapped.h"

#include <algorithm>
#include <string>

#include <glm/geometric.hpp>

#include "backbone/Estimators.h"
#include "backbone/cubemapped/Placement.h"

namespace aolib {

namespace {

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
    then(backbone->shading_);
    then(backbone->projection_);
    then(backbone->coverage_);
    then(backbone->sight_);
    then(backbone->outlines_);
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
    if (Status status = followScene(); !status) {
        return status;
    }
    auto projector = CubeMapProjector::create(context_.gl, CubeMapId{nextId_},
                                              Placement::freePosition(context_.scene, position),
                                              context_.options.cubeMaps.faceSize);
    if (!projector) {
        return projector.status();
    }
    if (Status status = build(*projector); !status) {
        return status;
    }
    projectors_.push_back(std::make_unique<CubeMapProjector>(std::move(*projector)));
    coverage_->restart();
    latestCoverage_.reset();
    return CubeMapId{nextId_++};
}

Status BackboneCubemapped::removeCubeMap(CubeMapId id) {
    const auto found = find(id);
    if (found == projectors_.end()) {
        return unknown(id);
    }
    projectors_.erase(found);
    coverage_->restart();
    latestCoverage_.reset();
    return {};
}

Status BackboneCubemapped::clear() {
    projectors_.clear();
    coverage_->restart();
    latestCoverage_.reset();
    return {};
}

std::vector<CubeMapInfo> BackboneCubemapped::cubeMaps() {
    std::vector<CubeMapInfo> infos;
    for (const auto& projector : projectors_) {
        infos.push_back(projector->info());
    }
    return infos;
}

Result<CubeMapImage> BackboneCubemapped::readCubeMap(CubeMapId id) {
    const auto found = find(id);
    if (found == projectors_.end()) {
        return unknown(id);
    }
    return (*found)->read(context_.gl);
}

std::vector<std::unique_ptr<CubeMapProjector>>::iterator BackboneCubemapped::find(CubeMapId id) {
    return std::find_if(projectors_.begin(), projectors_.end(),
                        [&](const auto& projector) { return projector->id() == id; });
}

// ---- Following the scene and the options --------------------------------------------------------

void BackboneCubemapped::markAllDirty() {
    for (const auto& projector : projectors_) {
        projector->dirty = true;
    }
}

void BackboneCubemapped::optionsChanged(const Options& before) {
    if (!sameEstimate(before, context_.options)) { // the radius is watched where it is used
        markAllDirty();
    }
}

Status BackboneCubemapped::followScene() {
    const std::vector<Scene::Change> changes = context_.scene.takeChanges();
    if (Status status = sceneGeometry_.update(context_.gl, context_.scene, changes,
                                              traitsOf(context_.options.estimator).layered);
        !status) {
        markAllDirty(); // the changes are taken and will not come again
        return status;
    }
    const float reach = radius();
    if (reach != builtRadius_) {
        builtRadius_ = reach;
        markAllDirty();
    }
    for (const Scene::Change& change : changes) {
        // Receivers up to a radius away from the change see a difference.
        const Bounds region = change.region.inflated(reach);
        for (const auto& projector : projectors_) {
            projector->dirty = projector->dirty || sight_->sees(context_, *projector, region);
        }
    }
    return {};
}

Status BackboneCubemapped::build(CubeMapProjector& projector) {
    const int faceSize = context_.options.cubeMaps.faceSize;
    if (projector.faceSize() == faceSize) {
        Status status = shading_->build(context_, sceneGeometry_, radius(), projector);
        builtInFrame_ += status ? 1 : 0;
        return status;
    }
    auto resized =
        CubeMapProjector::create(context_.gl, projector.id(), projector.position(), faceSize);
    if (!resized) {
        return resized.status();
    }
    if (Status status = build(*resized); !status) {
        return status; // the one of the old size stays
    }
    projector = std::move(*resized);
    return {};
}

// ---- Frame --------------------------------------------------------------------------------------

Status BackboneCubemapped::placeWhereDue(const Frame& frame) {
    if (const auto answer = coverage_->poll()) {
        latestCoverage_ = answer;
        shownCoverage_ = *answer;
    }
    const CubeMapOptions& options = context_.options.cubeMaps;
    if (!options.place || context_.scene.empty()) {
        return {};
    }
    std::vector<glm::vec3> positions;
    for (const auto& projector : projectors_) {
        positions.push_back(projector->position());
    }
    std::optional<float> coverage;
    if (latestCoverage_) {
        coverage = latestCoverage_->shaded;
    }
    if (!Placement::due(coverage, options.coverage, frame.position, positions,
                        context_.scene.bounds().diagonal())) {
        return {};
    }
    return addCubeMap(frame.position).status();
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

Result<const gl::RenderToTexture2D*> BackboneCubemapped::computeVisibility(const Frame& frame) {
    builtInFrame_ = 0;
    if (Status status = followScene(); !status) {
        return status;
    }
    if (Status status = placeWhereDue(frame); !status) {
        return status;
    }
    std::vector<CubeMapProjector*> projectors;
    if (!context_.scene.empty()) {
        projectors = nearest(frame.position);
    }
    for (CubeMapProjector* projector : projectors) {
        if (!projector->dirty) {
            continue;
        }
        if (Status status = build(*projector); !status) {
            return status;
        }
    }
    projectedInFrame_ = static_cast<int>(projectors.size());
    return projection_->apply(context_, frame, geometry_, projectors, kUnshaded);
}

Status BackboneCubemapped::finishFrame(const Frame& frame) {
    coverage_->count(context_, frame, geometry_, visibility_, ++framesCounted_);
    if (context_.options.cubeMaps.outlines) {
        outlines_->draw(context_, frame, nearest(frame.position));
    }
    return {};
}

void BackboneCubemapped::addStatistics(Statistics& statistics) {
    statistics.coverage = shownCoverage_.shaded;
    statistics.coverageFrame = shownCoverage_.frame;
    statistics.cubeMapsProjected = projectedInFrame_;
    statistics.cubeMapsBuilt = builtInFrame_;
    statistics.bytesFrame += projection_->bytes();
    statistics.bytesScene = sceneGeometry_.bytes();
    for (const auto& projector : projectors_) {
        statistics.bytesKept += projector->info().bytes;
    }
}

} // namespace aolib
