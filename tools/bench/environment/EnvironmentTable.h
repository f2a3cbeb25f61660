#pragma once

#include <string>
#include <vector>

#include "bench/environment/EnvironmentRun.h"

namespace aolib::bench {

/// All figures of all rows, comma-separated.
std::string environmentCsv(const std::vector<EnvironmentRow>& rows);

/// The errors as a table in Markdown, as docs/environment.md shows them: a line for each view and
/// environment, a column for each method.
/// @param drawn  those from vertices, with the time of a frame; else those from pixels.
std::string environmentMarkdown(const std::vector<EnvironmentRow>& rows, bool drawn);

} // namespace aolib::bench
