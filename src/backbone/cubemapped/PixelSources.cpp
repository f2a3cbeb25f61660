#include "backbone/cubemapped/PixelSources.h"

#include <utility>

namespace aolib {

PixelSources::Kind PixelSources::wanted() const {
    const Options& options = context_.options;
    const bool layered = options.estimator == Estimator::LayeredIntervals;
    if (!options.cubeMaps.repair || context_.scene.meshes().empty() || context_.renderer) {
        return Kind::None;
    }
    if (context_.tracer && options.estimator != Estimator::HorizonSplit) {
        return Kind::Traced;
    }
    return layered ? Kind::Layered : Kind::None;
}

AoStatus PixelSources::choose(Kind kind) {
    kind_ = Kind::None;
    if (kind == Kind::Traced && !traced_) {
        auto shader = TracedPixels::createShader(context_);
        if (!shader) {
            return shader.status();
        }
        traced_ = std::make_unique<gl::GLSLShader>(std::move(*shader));
    }
    if (kind == Kind::Layered && !layered_) {
        auto shared = LayeredPixels::createShared(context_);
        if (!shared) {
            return shared.status();
        }
        layered_ = std::make_unique<LayeredPixels::Shared>(std::move(*shared));
    }
    kind_ = kind;
    return {};
}

std::unique_ptr<AbstractPixelSource> PixelSources::make(TracerQueue* queue,
                                                        DeferredShading* shading, unsigned slot) {
    switch (kind_) {
    case Kind::Traced:
        return std::make_unique<TracedPixels>(*traced_, *queue, slot);
    case Kind::Layered:
        return std::make_unique<LayeredPixels>(*layered_, geometry_, *shading);
    default:
        return nullptr;
    }
}

void PixelSources::dropTracer() {
    kind_ = Kind::None;
}

} // namespace aolib
