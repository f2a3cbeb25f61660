#pragma once

#include <cstddef>
#include <vector>

#include "bench/ParetoRun.h"

namespace aolib::bench {

/// A method over all its cases. Means of RMSE are over cases; negative where there are none.
struct MethodSummary {
    Method method;
    std::size_t cases = 0;    ///< measured
    std::size_t failures = 0; ///< cases that gave no figures
    double rmse = -1.0;       ///< mean, all cases
    double rmseSolid = -1.0;  ///< mean, all but foliage
    double rmseGenerated = -1.0;
    double rmseFoliage = -1.0;
    double worst = -1.0;      ///< greatest RMSE
    double rmseFirst = -1.0;  ///< mean, after the first frame that shows anything
    double frameMs = -1.0;    ///< median over cases of their medians
    double frameMsLow = -1.0; ///< quartiles of those
    double frameMsHigh = -1.0;
    double convergedMs = -1.0; ///< median over cases of their medians
    double buildMs = -1.0;     ///< mean over cases of their medians
};

/// One per method, in the order in which they first occur.
std::vector<MethodSummary> summarise(const std::vector<ParetoRow>& rows);

} // namespace aolib::bench
