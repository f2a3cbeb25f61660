#pragma once

#include "bench/Measurement.h"
#include "bench/MethodTable.h"
#include "bench/OpenedScene.h"
#include "bench/Truth.h"

namespace aolib::bench {

/// Computes the occlusion of surface elements once, all cores; every frame interpolates it to the
/// pixels, which find their triangles before the clock starts: a renderer gets that for nothing.
Measurement measureSurfaceElements(const SurfaceElementsMethod& method, const OpenedScene& scene,
                                   const BenchCase& which, const Truth& truth,
                                   const PictureSize& size, const TimingSettings& timing);

} // namespace aolib::bench
