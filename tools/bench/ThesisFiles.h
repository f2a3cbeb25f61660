#pragma once

#include <string>
#include <vector>

#include "bench/ThesisRun.h"

namespace aolib::bench {

/// One line per measurement, after a header. Times in milliseconds; empty: not known.
std::string thesisCsv(const std::vector<ThesisRow>& rows);

/// Machine, settings and every measurement.
std::string thesisJson(const ThesisRunSettings& settings, const std::vector<ThesisRow>& rows);

/// Writes thesis.csv and thesis.json into the output folder. Returns why that failed, or an empty
/// text.
std::string writeThesisFiles(const ThesisRunSettings& settings, const std::vector<ThesisRow>& rows);

} // namespace aolib::bench
