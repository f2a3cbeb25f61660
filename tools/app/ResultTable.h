#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "app/Comparison.h"
#include "app/RenderJob.h"
#include "app/Table.h"

namespace aolib::app {

/// The one table of "aolib render" and "aolib demo": a row for each rendered scene.
class ResultTable {
public:
    /// Which frames its times are of, for beneath it.
    static constexpr const char* kFrames =
        "ms/frame are medians. AO computing: frames until all is computed, workers busy; AO "
        "converged: frames\nafter that, workers idle; host: the scene itself in those. build: wall "
        "clock until all is computed\n";

    ResultTable();

    void add(const std::string& scene, std::size_t triangles, const RenderResult& result,
             const std::optional<ErrorAgainstTruth>& error);
    std::string text() const { return table_.text(); }

private:
    Table table_;
};

} // namespace aolib::app
