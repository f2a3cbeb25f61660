#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "bench/ErrorFigures.h"
#include "bench/PassTimer.h"
#include "bench/Spread.h"

namespace aolib::bench {

/// A moment of a build: what the picture was worth after so much time.
struct Progressed {
    double ms = 0.0;   ///< wall clock since the build began, host's drawing left out
    double rmse = 0.0; ///< of the picture shown then
};

/// What a method cost and gave in a case. Times are wall clock with the GPU's work done,
/// milliseconds; negative where a method has no such thing.
struct Measurement {
    std::string failure; ///< why there are no figures; empty when all went well

    Spread frameMs;             ///< per frame once converged, what the method adds
    Spread hostMs;              ///< per frame, the host's own drawing
    Spread buildMs;             ///< until converged, beyond what as many converged frames cost
    Spread convergedMs;         ///< until converged, wall clock, frames included
    double firstMs = -1.0;      ///< until the first frame that shows the method's result has ended
    double worstFrameMs = -1.0; ///< the longest frame until converged
    int framesToConverge = 0;
    bool converged = true; ///< false where timing ran out

    ErrorFigures first;           ///< after the first frame that shows the method's result
    ErrorFigures final;           ///< converged
    double coverage = -1.0;       ///< share of pixels with geometry that are shaded
    std::vector<Progressed> path; ///< error over time; one entry where nothing is progressive

    std::vector<PassTime> framePasses; ///< of a converged frame; empty unless asked for
    std::vector<PassTime> buildPasses; ///< of one cube map's build; empty unless asked for

    std::size_t bytesKept = 0;    ///< GPU memory of all cube maps
    std::size_t bytesCapture = 0; ///< GPU memory that a build took and gave back, at its peak
    std::size_t bytesFrame = 0;   ///< GPU memory of the per-frame targets
};

/// How patiently to measure.
struct TimingSettings {
    int repeat = 1;            ///< builds per method and case
    int frames = 7;            ///< timed per build, at least
    bool passes = false;       ///< also time the passes of a frame and of a build
    double buildSeconds = 600; ///< a build that has not converged after that is taken as it is
};

} // namespace aolib::bench
