#include "backbone/cubemapped/BuildSchedule.h"

#include <algorithm>
#include <chrono>

#include "backbone/cubemapped/LayeredPixels.h"
#include "backbone/cubemapped/TracedPixels.h"

namespace aolib {

namespace {

/// Frames over which a complete cube map comes in: its quality rises from kNewcomer to its own. One
/// that is to go falls as fast.
constexpr int kFramesToComeIn = 32;

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
        traced_->setRadius(radius_());
        source_ = traced_.get();
    } else {
        if (!raster_) {
            auto raster = RasterTexels::create(context_, geometry_, store_, blocks_, radius_);
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
    pixels_ = nullptr;
    const bool traced = tracesPixels();
    const bool layered = context_.options.estimator == Estimator::LayeredIntervals &&
                         !context_.scene.meshes().empty() && !context_.renderer;
    if (!context_.options.cubeMaps.repair || !(traced || layered)) {
        return {};
    }
    std::unique_ptr<AbstractPixelSource>& wanted = traced ? tracedPixels_ : layeredPixels_;
    if (traced) {
        askTracer();
    }
    if (!wanted) {
        auto made = traced ? TracedPixels::create(context_, *tracerQueue_)
                           : LayeredPixels::create(context_, geometry_, raster_->shading());
        if (!made) {
            return made.status();
        }
        wanted = std::move(*made);
    }
    pixels_ = wanted.get();
    return {};
}

void BuildSchedule::askTracer() {
    if (!tracerQueue_) {
        tracerQueue_ = std::make_unique<TracerQueue>(*context_.tracer);
        tracerQueue_->setScene(context_.scene);
    }
}

bool BuildSchedule::tracesPixels() const {
    return context_.tracer && !context_.scene.meshes().empty() && !context_.renderer &&
           context_.options.estimator != Estimator::HorizonSplit;
}

void BuildSchedule::sceneChanged() {
    if (tracerQueue_) {
        tracerQueue_->setScene(context_.scene);
    }
    if (traced_) {
        traced_->sceneChanged();
    }
}

void BuildSchedule::changedBehind(const CubeMapProjector& projector, const Bounds& region) {
    if (raster_) {
        raster_->changedBehind(projector.id(), region);
    }
}

void BuildSchedule::dropTracer() {
    source_ = nullptr;
    pixels_ = nullptr;
    traced_.reset();
    tracedPixels_.reset();
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
        const bool again = projector->outdated && !source_->capturing(projector->id());
        const bool begins = projector->dirty || again;
        if (begins) {
            begin(*projector);
        }
        if (atOnce() && (begins || source_->lacks(*projector))) {
            projector->tiles.askAll();
            if (AoStatus status = source_->complete(*projector); !status) {
                return status;
            }
        }
        projector->dirty = false;
    }
    const AoStatus status = atOnce() ? AoStatus() : advance(projectors);
    for (CubeMapProjector* projector : projectors) {
        bringIn(*projector);
    }
    return status;
}

void BuildSchedule::begin(CubeMapProjector& projector) {
    forget(projector.id());
    projector.outdated = false;
    projector.dropBlocks(store_, blocks_);
    projector.buildMs = 0.0;
    projector.tiles.restart();
    ++begun_;
}

AoStatus BuildSchedule::advance(const std::vector<CubeMapProjector*>& projectors) {
    const auto lacking = std::find_if(projectors.begin(), projectors.end(),
                                      [&](const auto* one) { return source_->lacks(*one); });
    const auto start = std::chrono::steady_clock::now();
    AoStatus status =
        source_->advance(projectors, static_cast<double>(context_.options.frameBudget));
    if (lacking != projectors.end()) { // the one that is worked on
        const std::chrono::duration<double, std::milli> spent =
            std::chrono::steady_clock::now() - start;
        (*lacking)->buildMs += spent.count();
    }
    return status;
}

void BuildSchedule::bringIn(CubeMapProjector& projector) const {
    constexpr float kStep = -CubeMapProjector::kNewcomer / kFramesToComeIn;
    if (projector.use.retiring) {
        projector.bias = std::max(projector.bias - kStep, CubeMapProjector::kNewcomer);
    } else if (atOnce()) {
        projector.bias = 0.0F;
    } else if (projector.bias < 0.0F && projector.shown && !projector.tiles.lacks(passes_)) {
        projector.bias = std::min(projector.bias + kStep, 0.0F);
    }
}

bool BuildSchedule::finished(const CubeMapProjector& projector) const {
    // One that no survey has looked at yet has not begun.
    return projector.shown && projector.bias >= 0.0F && !source_->lacks(projector);
}

} // namespace aolib
