#pragma once

#include <memory>
#include <vector>

#include <aolib/ProcAddressLoader.h>

#include "bench/Measurement.h"
#include "bench/MethodTable.h"
#include "bench/OpenedScene.h"
#include "bench/Truth.h"
#include "content/LoadError.h"
#include "gl/Functions.h"

namespace aolib::bench {

/// Measures the library through its facade, as a host uses it, in one scene. The scene is
/// described once; methods follow each other by setOptions(), each after a small build that makes
/// the driver compile its shaders. Context: the one current at create(), for every call.
class FacadeRun {
public:
    /// @param gl,scene  must outlive it. Errors: what the library or the host's renderer rejects.
    static Result<FacadeRun, LoadError> create(const gl::Functions& gl,
                                               const ProcAddressLoader& loader,
                                               const OpenedScene& scene, const PictureSize& size);
    FacadeRun(FacadeRun&&) noexcept;
    ~FacadeRun();

    /// Measures a method. A failure of the library is told in the measurement.
    Measurement measure(const FacadeMethod& method, const BenchCase& which, const Truth& truth,
                        const TimingSettings& timing);

    /// What the host draws: depths of all pixels, 0 to 1, row 0 at the bottom.
    std::vector<float> drawDepths(const NamedCamera& camera);

private:
    struct Impl;
    explicit FacadeRun(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

} // namespace aolib::bench
