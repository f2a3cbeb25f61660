#pragma once

#include <filesystem>
#include <string>

#include "bench/plot/Plot.h"

namespace aolib::bench {

/// Writes a plot as SVG and as PNG. @param stem  path without extension; its folder must exist.
/// Returns why that failed, or an empty text.
std::string writePlot(const Plot& plot, const std::filesystem::path& stem);

} // namespace aolib::bench
