#include "host/AoInstance.h"

#include <utility>

#include <aolib/RayTracing.h>

namespace aolib::host {

Result<AmbientOcclusion> createInstance(const ProcAddressLoader& loader, const Options& options) {
    Result<AmbientOcclusion> ao = AmbientOcclusion::create(loader, options);
    if (!ao) {
        return ao;
    }
    auto tracer = createTexelTracer();
    if (!tracer) {
        return tracer.status();
    }
    ao->setTexelTracer(std::move(*tracer));
    return ao;
}

} // namespace aolib::host
