#pragma once

#include <vector>

#include "bench/ParetoRun.h"

namespace aolib::app {

/// The scenes and the methods of `aolib bench pareto`.
void printLists();

/// A line per method: error over groups of cases, and cost.
void printSummary(const std::vector<bench::ParetoRow>& rows);

/// What each pass takes: medians over cases, method by method.
void printPasses(const std::vector<bench::ParetoRow>& rows);

} // namespace aolib::app
