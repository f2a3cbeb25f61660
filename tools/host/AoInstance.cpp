#include "host/AoInstance.h"

#include <utility>

#include <aolib/RayTracing.h>

#include "parallel/CoreCount.h"

namespace aolib::host {

AoStatus giveTracer(AmbientOcclusion& ao) {
    auto tracer = createTexelTracer(coreCount());
    if (tracer) {
        ao.setTexelTracer(std::move(*tracer));
    }
    return tracer.status();
}

Result<AmbientOcclusion> createInstance(const ProcAddressLoader& loader, const Options& options) {
    Result<AmbientOcclusion> ao = AmbientOcclusion::create(loader, options);
    if (!ao) {
        return ao;
    }
    if (AoStatus status = giveTracer(*ao); !status) {
        return status;
    }
    return ao;
}

} // namespace aolib::host
