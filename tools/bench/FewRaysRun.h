#pragma once

#include "bench/Measurement.h"
#include "bench/MethodTable.h"
#include "bench/OpenedScene.h"
#include "bench/Truth.h"

namespace aolib::bench {

/// Traces every pixel anew in every frame, on all cores, in packets of well distributed rays: as
/// fast and as good as the component aolib::raytracing traces texels. The surface points are found
/// before the clock starts: a renderer has them in its depth buffer.
Measurement measureFewRays(const FewRaysMethod& method, const OpenedScene& scene,
                           const BenchCase& which, const Truth& truth, const PictureSize& size,
                           const TimingSettings& timing);

} // namespace aolib::bench
