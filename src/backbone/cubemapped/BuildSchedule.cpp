#include "backbone/cubemapped/BuildSchedule.h"

#include <algorithm>
#include <chrono>

namespace aolib {

namespace {

/// Frames over which a complete cube map comes in: its quality rises from kNewcomer to its own. One
/// that is to go falls as fast.
constexpr int kFramesToComeIn = 32;

double millisecondsFrom(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
        .count();
}

} // namespace

// ---- Where texels and pixels come from ----------------------------------------------------------

AoStatus BuildSchedule::chooseSource() {
    const AoStatus status = chooseTexels();
    return status ? choosePixels() : status;
}

AoStatus BuildSchedule::chooseTexels() {
    if (context_.options.estimator == Estimator::RayTraced) {
        if (!context_.tracer) {
            return {StatusCode::MissingCapability,
                    "Estimator::RayTraced needs a tracer; give one by setTexelTracer, as "
                    "createTexelTracer() of aolib/RayTracing.h makes it"};
        }
        if (context_.scene.meshes().empty()) {
            return {StatusCode::NoScene,
                    "Estimator::RayTraced needs triangles: rays do not meet what a scene renderer "
                    "draws"};
        }
        askTracer();
        if (!traced_) {
            traced_ = std::make_unique<RayTracedTexels>(context_, store_, blocks_, *tracerQueue_);
        }
        source_ = traced_.get();
    } else {
        if (!raster_) {
            auto raster = RasterTexels::create(context_, geometry_, store_, blocks_);
            if (!raster) {
                return raster.status();
            }
            raster_ = std::move(*raster);
        }
        source_ = raster_.get();
    }
    passes_ = source_->passes();
    return {};
}

AoStatus BuildSchedule::choosePixels() {
    const PixelSources::Kind kind = pixelSources_.wanted();
    if (kind == PixelSources::Kind::Traced) {
        askTracer();
    }
    return pixelSources_.choose(kind);
}

void BuildSchedule::askTracer() {
    if (!tracerQueue_) {
        tracerQueue_ = std::make_unique<TracerQueue>(*context_.tracer);
        tracerQueue_->setScene(context_.scene);
    }
}

void BuildSchedule::sceneChanged(const std::vector<std::unique_ptr<CubeMapProjector>>& projectors,
                                 const std::vector<Scene::Change>& changes, float reach) {
    if (tracerQueue_) {
        tracerQueue_->setScene(context_.scene);
    }
    for (const auto& projector : projectors) {
        for (const Scene::Change& change : changes) {
            if (source_ != nullptr && !projector->dirty) {
                source_->sceneChanged(*projector, change, reach);
            }
        }
    }
}

void BuildSchedule::dropTracer() {
    source_ = nullptr;
    pixelSources_.dropTracer();
    traced_.reset();
    tracerQueue_.reset();
}

void BuildSchedule::forget(CubeMapId id) {
    if (raster_) {
        raster_->forget(id);
    }
    if (traced_) {
        traced_->forget(id);
    }
}

// ---- When they are computed ---------------------------------------------------------------------

AoStatus BuildSchedule::compute(const std::vector<CubeMapProjector*>& projectors) {
    if (AoStatus status = chooseSource(); !status) {
        return status;
    }
    for (CubeMapProjector* projector : projectors) {
        const bool again = projector->outdated && (atOnce() || source_->mayRestart(*projector));
        const bool begins = projector->dirty || again;
        if (begins) {
            begin(*projector);
        }
        if (atOnce() && (begins || source_->lacks(*projector))) {
            projector->tiles.askAll();
            if (AoStatus status = complete(*projector); !status) {
                projector->dirty = true; // some of it may be lost
                return status;
            }
        }
        projector->dirty = false;
    }
    const AoStatus status =
        atOnce() ? AoStatus()
                 : advance(projectors, static_cast<double>(context_.options.frameBudget));
    for (CubeMapProjector* projector : projectors) {
        bringIn(*projector);
    }
    return status;
}

void BuildSchedule::begin(CubeMapProjector& projector) {
    if (projector.dirty) {
        forget(projector.id());
        projector.dropBlocks(store_, blocks_);
        projector.tiles.setAllOutdated();
    }
    source_->restart(projector);
    projector.outdated = false;
    projector.buildMs = 0.0;
    ++begun_;
}

AoStatus BuildSchedule::complete(CubeMapProjector& projector) {
    const auto start = std::chrono::steady_clock::now();
    AoStatus status = source_->complete(projector);
    projector.buildMs += millisecondsFrom(start);
    return status;
}

Result<bool> BuildSchedule::completeSome(const std::vector<CubeMapProjector*>& projectors,
                                         double milliseconds) {
    if (AoStatus status = chooseSource(); !status) {
        return status;
    }
    for (CubeMapProjector* projector : projectors) {
        if (projector->dirty || (projector->outdated && source_->mayRestart(*projector))) {
            begin(*projector);
            projector->dirty = false;
        }
        projector->tiles.askAll();
    }
    if (AoStatus status = advance(projectors, milliseconds); !status) {
        return status;
    }
    bool complete = true;
    for (CubeMapProjector* projector : projectors) {
        const bool lacks = !projector->shown || projector->outdated || source_->lacks(*projector);
        projector->bias = lacks ? projector->bias : 0.0F;
        complete = complete && !lacks;
    }
    if (!complete) {
        source_->await(milliseconds);
    }
    return complete;
}

AoStatus BuildSchedule::advance(const std::vector<CubeMapProjector*>& projectors,
                                double milliseconds) {
    const auto lacking = std::find_if(projectors.begin(), projectors.end(),
                                      [&](const auto* one) { return source_->lacks(*one); });
    const auto start = std::chrono::steady_clock::now();
    AoStatus status = source_->advance(projectors, milliseconds);
    if (lacking != projectors.end()) { // the one that is worked on
        (*lacking)->buildMs += millisecondsFrom(start);
    }
    return status;
}

void BuildSchedule::bringIn(CubeMapProjector& projector) const {
    constexpr float kStep = -CubeMapProjector::kNewcomer / kFramesToComeIn;
    if (projector.use.retiring) {
        projector.bias = std::max(projector.bias - kStep, CubeMapProjector::kNewcomer);
    } else if (atOnce()) {
        projector.bias = 0.0F;
    } else if (projector.bias < 0.0F && projector.shown &&
               !projector.tiles.lacksUndisturbed(passes_)) {
        projector.bias = std::min(projector.bias + kStep, 0.0F);
    }
}

bool BuildSchedule::finished(const CubeMapProjector& projector, const AskedTiles& asked) const {
    // One that no survey has looked at yet has not begun.
    if (!projector.shown || projector.outdated || projector.bias < 0.0F) {
        return false;
    }
    return !source_->lacks(projector) ||
           (source_->keeps(projector) && !projector.tiles.lacksAny(asked, passes_));
}

} // namespace aolib
