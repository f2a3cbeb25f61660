#pragma once

#include <string>
#include <vector>

#include "bench/ParetoRun.h"

namespace aolib::bench {

/// Plots of the case that the last rows belong to: error against the cost of a frame, and error
/// against the time of a build, into the folder "cases" of the output folder.
/// Returns why that failed, or an empty text.
std::string writeCasePlots(const ParetoSettings& settings, const std::vector<ParetoRow>& rows);

/// The same two over all cases: means of RMSE.
std::string writeMeanPlots(const ParetoSettings& settings, const std::vector<ParetoRow>& rows);

} // namespace aolib::bench
