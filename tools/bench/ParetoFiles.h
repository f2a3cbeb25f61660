#pragma once

#include <string>
#include <vector>

#include "bench/ParetoRun.h"

namespace aolib::bench {

/// One line per case and method, after a header. Times in milliseconds; empty: not known.
std::string paretoCsv(const std::vector<ParetoRow>& rows);

/// Everything: machine, settings, every measurement with its error over time, and the summary.
std::string paretoJson(const ParetoSettings& settings, const std::vector<ParetoRow>& rows);

/// Writes pareto.csv and pareto.json into the output folder. Returns why that failed, or an empty
/// text.
std::string writeParetoFiles(const ParetoSettings& settings, const std::vector<ParetoRow>& rows);

} // namespace aolib::bench
