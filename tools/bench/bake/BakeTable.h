#pragma once

#include <string>
#include <vector>

#include "bench/bake/BakeRun.h"
#include "bench/plot/Plot.h"

namespace aolib::bench {

/// All figures of all rows, comma-separated.
std::string bakeCsv(const std::vector<BakeRow>& rows);
/// The rows of such a text; lines that are none are left out.
std::vector<BakeRow> rowsOfBakeCsv(const std::string& text);

/// The rows as a table in Markdown, as docs/baking.md shows them.
std::string bakeMarkdown(const std::vector<BakeRow>& rows);

/// Seconds over triangles, a curve per method and number of samples, beside those of McGraw and
/// Sowers 2008 where these are 512 or 1024.
Plot bakePlot(const std::vector<BakeRow>& rows, const std::string& subtitle);

} // namespace aolib::bench
