#include "backbone/TexelSources.h"

#include <utility>

#include "backbone/refine/RayTracedRefiner.h"

namespace aolib {

namespace {

RefinerKind refinerFor(const BackboneContext& context) {
    if (!context.options.cubeMaps.refineStaticViews || context.scene.meshes().empty() ||
        context.renderer) {
        return RefinerKind::None;
    }
    const EstimatorTraits& traits = traitsOf(context.options.estimator);
    return context.tracer ? traits.refinerWithTracer : traits.refiner;
}

} // namespace

AoStatus TexelSources::choose() {
    const AoStatus status =
        traitsOf(context_.options.estimator).needsTracer ? chooseTraced() : chooseRaster();
    return status ? chooseRefiner() : status;
}

AoStatus TexelSources::chooseTraced() {
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
    makeTracerQueue();
    if (!traced_) {
        traced_ = std::make_unique<RayTracedTexels>(context_, atlas_, *tracerQueue_);
    }
    source_ = traced_.get();
    return {};
}

AoStatus TexelSources::chooseRaster() {
    if (!raster_) {
        if (AoStatus status = makeShading(); !status) {
            return status;
        }
        auto raster = RasterTexels::create(context_, geometry_, atlas_, *shading_);
        if (!raster) {
            return raster.status();
        }
        raster_ = std::move(*raster);
    }
    source_ = raster_.get();
    return {};
}

AoStatus TexelSources::chooseRefiner() {
    refinerKind_ = RefinerKind::None;
    const RefinerKind kind = refinerFor(context_);
    if (kind == RefinerKind::RayTraced) {
        makeTracerQueue();
        if (!lowConfidence_) {
            auto shader = RayTracedRefiner::createShader(context_);
            if (!shader) {
                return shader.status();
            }
            lowConfidence_ = std::make_unique<gl::GLSLShader>(std::move(*shader));
        }
    }
    if (kind == RefinerKind::Layered && !layeredRefiners_) {
        auto shared = LayeredRefiner::createShared(context_);
        if (!shared) {
            return shared.status();
        }
        layeredRefiners_ = std::make_unique<LayeredRefiner::Shared>(std::move(*shared));
    }
    refinerKind_ = kind;
    return {};
}

AoStatus TexelSources::makeShading() {
    if (!shading_) {
        auto shading = DeferredShading::create(context_);
        if (!shading) {
            return shading.status();
        }
        shading_ = std::make_unique<DeferredShading>(std::move(*shading));
    }
    return {};
}

void TexelSources::makeTracerQueue() {
    if (!tracerQueue_) {
        tracerQueue_ = std::make_unique<TracerQueue>(*context_.tracer);
        tracerQueue_->setScene(context_.scene);
    }
}

std::unique_ptr<AbstractPixelRefiner> TexelSources::makeRefiner(unsigned slot) {
    switch (refinerKind_) {
    case RefinerKind::RayTraced:
        return std::make_unique<RayTracedRefiner>(*lowConfidence_, *tracerQueue_, slot);
    case RefinerKind::Layered:
        return std::make_unique<LayeredRefiner>(*layeredRefiners_, geometry_, *shading_);
    case RefinerKind::None:
        break;
    }
    return nullptr;
}

void TexelSources::sceneChanged() {
    if (tracerQueue_) {
        tracerQueue_->setScene(context_.scene);
    }
}

void TexelSources::dropTracer() {
    source_ = nullptr;
    refinerKind_ = RefinerKind::None;
    traced_.reset();
    tracerQueue_.reset();
}

void TexelSources::forget(CubeMapId id) {
    if (raster_) {
        raster_->forget(id);
    }
    if (traced_) {
        traced_->forget(id);
    }
}

} // namespace aolib
