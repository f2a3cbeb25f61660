#include "host/AoInstance.h"

#include <algorithm>
#include <thread>
#include <utility>

#include <aolib/RayTracing.h>

namespace aolib::host {

AoStatus giveTracer(AmbientOcclusion& ao) {
    auto tracer =
        createTexelTracer(static_cast<int>(std::max(1U, std::thread::hardware_concurrency())));
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
