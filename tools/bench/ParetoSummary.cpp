#include "bench/ParetoSummary.h"

#include <algorithm>
#include <utility>

namespace aolib::bench {

namespace {

double mean(const std::vector<double>& values) {
    double sum = 0.0;
    for (const double value : values) {
        sum += value;
    }
    return values.empty() ? -1.0 : sum / static_cast<double>(values.size());
}

/// Figures of one method, case by case.
struct Columns {
    Method method;
    std::size_t failures = 0;
    std::vector<double> rmse;
    std::vector<double> solid;
    std::vector<double> generated;
    std::vector<double> foliage;
    std::vector<double> first;
    std::vector<double> frameMs;
    std::vector<double> buildMs;
    std::vector<double> convergedMs;

    void add(const ParetoRow& row) {
        const Measurement& m = row.measured;
        if (!m.failure.empty() || m.final.rmse < 0.0) {
            ++failures;
            return;
        }
        const SceneKind kind = row.which.scene.kind;
        rmse.push_back(m.final.rmse);
        (kind == SceneKind::Foliage ? foliage : solid).push_back(m.final.rmse);
        if (kind == SceneKind::Generated) {
            generated.push_back(m.final.rmse);
        }
        first.push_back(m.first.rmse);
        frameMs.push_back(m.frameMs.median);
        buildMs.push_back(m.buildMs.median);
        convergedMs.push_back(m.convergedMs.median);
    }

    MethodSummary summary() const {
        MethodSummary summary;
        summary.method = method;
        summary.cases = rmse.size();
        summary.failures = failures;
        summary.rmse = mean(rmse);
        summary.rmseSolid = mean(solid);
        summary.rmseGenerated = mean(generated);
        summary.rmseFoliage = mean(foliage);
        summary.worst = rmse.empty() ? -1.0 : *std::max_element(rmse.begin(), rmse.end());
        summary.rmseFirst = mean(first);
        const Spread frames = spreadOf(frameMs);
        summary.frameMs = frames.median;
        summary.frameMsLow = frames.low;
        summary.frameMsHigh = frames.high;
        summary.buildMs = mean(buildMs);
        summary.convergedMs = spreadOf(convergedMs).median;
        return summary;
    }
};

} // namespace

std::vector<MethodSummary> summarise(const std::vector<ParetoRow>& rows) {
    std::vector<Columns> columns;
    for (const ParetoRow& row : rows) {
        auto found = std::find_if(columns.begin(), columns.end(), [&](const Columns& c) {
            return c.method.name == row.method.name;
        });
        if (found == columns.end()) {
            columns.push_back({});
            columns.back().method = row.method;
            found = columns.end() - 1;
        }
        found->add(row);
    }
    std::vector<MethodSummary> summaries;
    for (const Columns& c : columns) {
        summaries.push_back(c.summary());
    }
    return summaries;
}

} // namespace aolib::bench
