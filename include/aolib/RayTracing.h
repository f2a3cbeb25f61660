#pragma once

#include <memory>

#include <aolib/AbstractTexelTracer.h>
#include <aolib/RayTracingExport.h>
#include <aolib/Status.h>

namespace aolib {

/// Makes the tracer of the component `aolib::raytracing`, which traces with Embree on the CPU.
/// @param threads  number of workers, which start with the first work; 0 = number of cores minus
///                 one, at least one.
/// Errors: InvalidOption (threads below 0 or above 1024), MissingCapability (Embree does not run on
/// this processor), OutOfMemory. Since 0.1.
AOLIB_RAYTRACING_EXPORT Result<std::unique_ptr<AbstractTexelTracer>>
createTexelTracer(int threads = 0);

} // namespace aolib
