#pragma once

#include "app/Failure.h"
#include "app/Progress.h"
#include "app/ViewFlags.h"
#include "image/Image.h"

namespace aolib::app {

/// A ray-traced picture of W.
struct Truth {
    FloatImage visibility;    ///< background -1
    FloatImage standardError; ///< of each W, background -1
    double noise = 0.0;       ///< expected RMSE of W from sampling
    int rays = 0;             ///< per pixel, as traced
};

/// Traces the W of a view. @param options  radius (above 0) and falloff are read.
/// Errors: BadInput.
Result<Truth, Failure> traceTruth(const View& view, const Options& options, int rays,
                                  Progress& progress);

} // namespace aolib::app
