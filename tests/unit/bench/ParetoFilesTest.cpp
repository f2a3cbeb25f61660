#include "bench/ParetoFiles.h"

#include <algorithm>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "bench/ParetoSummary.h"

namespace aolib::bench {
namespace {

ParetoRow rowOf(const std::string& scene, SceneKind kind, const std::string& method, double rmse,
                double frameMs) {
    ParetoRow row;
    row.which.scene = {scene, kind, false};
    row.camera = "front";
    row.method.name = method;
    row.measured.final.rmse = rmse;
    row.measured.first.rmse = 2.0 * rmse;
    row.measured.frameMs = spreadOf({frameMs});
    row.measured.buildMs = spreadOf({10.0});
    row.measured.path = {{5.0, 2.0 * rmse}, {10.0, rmse}};
    return row;
}

std::vector<ParetoRow> sampleRows() {
    std::vector<ParetoRow> rows{
        rowOf("town", SceneKind::Generated, "a", 0.01, 4.0),
        rowOf("ivy", SceneKind::Foliage, "a", 0.07, 8.0),
        rowOf("bunny", SceneKind::Model, "a", 0.04, 6.0),
        rowOf("town", SceneKind::Generated, "b", 0.10, 1.0),
    };
    rows.push_back(rowOf("ivy", SceneKind::Foliage, "b", 0.2, 1.0));
    rows.back().measured.failure = "out of \"memory\", it said";
    return rows;
}

TEST(ParetoSummary, AveragesOverGroupsOfCases) {
    const std::vector<MethodSummary> summaries = summarise(sampleRows());
    ASSERT_EQ(summaries.size(), 2U);
    const MethodSummary& a = summaries[0];
    EXPECT_EQ(a.cases, 3U);
    EXPECT_NEAR(a.rmse, 0.04, 1e-12);
    EXPECT_NEAR(a.rmseSolid, 0.025, 1e-12);
    EXPECT_NEAR(a.rmseGenerated, 0.01, 1e-12);
    EXPECT_NEAR(a.rmseFoliage, 0.07, 1e-12);
    EXPECT_NEAR(a.worst, 0.07, 1e-12);
    EXPECT_NEAR(a.rmseFirst, 0.08, 1e-12);
    EXPECT_DOUBLE_EQ(a.frameMs, 6.0);
}

TEST(ParetoSummary, CountsFailuresAndLeavesThemOut) {
    const MethodSummary b = summarise(sampleRows())[1];
    EXPECT_EQ(b.cases, 1U);
    EXPECT_EQ(b.failures, 1U);
    EXPECT_NEAR(b.rmse, 0.10, 1e-12);
    EXPECT_LT(b.rmseFoliage, 0.0);
}

TEST(ParetoFiles, CsvHasAsManyCellsInEveryLine) {
    std::istringstream csv(paretoCsv(sampleRows()));
    std::string line;
    std::size_t expected = 0;
    int lines = 0;
    while (std::getline(csv, line)) {
        std::size_t cells = 1;
        bool quoted = false;
        for (const char c : line) {
            quoted = quoted != (c == '"');
            cells += c == ',' && !quoted ? 1 : 0;
        }
        expected = lines == 0 ? cells : expected;
        EXPECT_EQ(cells, expected) << line;
        ++lines;
    }
    EXPECT_EQ(lines, 6);
}

TEST(ParetoFiles, JsonHoldsEverything) {
    ParetoSettings settings;
    settings.machine = {"a cpu", 2, "a driver \xff", "abc", "2026-01-01T00:00:00Z"};
    settings.commandLine = "aolib bench pareto";
    const nlohmann::json json = nlohmann::json::parse(paretoJson(settings, sampleRows()));
    EXPECT_EQ(json["machine"]["cpu"], "a cpu");
    EXPECT_EQ(json["machine"]["command"], "aolib bench pareto");
    EXPECT_EQ(json["results"].size(), 5U);
    EXPECT_EQ(json["results"][0]["ms_rmse"].size(), 2U);
    EXPECT_TRUE(json["results"][0]["first_ms"].is_null());
    EXPECT_EQ(json["summary"].size(), 2U);
}

} // namespace
} // namespace aolib::bench
