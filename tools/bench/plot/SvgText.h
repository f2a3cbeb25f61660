#pragma once

#include <string>

#include "bench/plot/Drawing.h"

namespace aolib::bench {

/// The drawing as an SVG document.
std::string svgText(const Drawing& drawing);

} // namespace aolib::bench
