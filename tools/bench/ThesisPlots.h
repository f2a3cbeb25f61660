#pragma once

#include <string>
#include <vector>

#include "bench/ThesisRun.h"

namespace aolib::bench {

/// A plot per figure that has rows, and one of memory over face size: a curve per scene and
/// estimator. Returns why writing failed, or an empty text.
std::string writeThesisPlots(const ThesisRunSettings& settings, const std::vector<ThesisRow>& rows);

} // namespace aolib::bench
