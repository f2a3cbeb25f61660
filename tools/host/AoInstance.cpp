#include "host/AoInstance.h"

#include <algorithm>
#include <thread>
#include <utility>

#include <aolib/RayTracing.h>

namespace aolib::host {

Result<AmbientOcclusion> createInstance(const ProcAddressLoader& loader, const Options& options) {
    Result<AmbientOcclusion> ao = AmbientOcclusion::create(loader, options);
    if (!ao) {
        return ao;
    }
    // All cores: a tool waits for the result.
    auto tracer =
        createTexelTracer(static_cast<int>(std::max(1U, std::thread::hardware_concurrency())));
    if (!tracer) {
        return tracer.status();
    }
    ao->setTexelTracer(std::move(*tracer));
    return ao;
}

} // namespace aolib::host
