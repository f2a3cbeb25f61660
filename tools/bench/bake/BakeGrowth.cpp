#include "bench/bake/BakeGrowth.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace aolib::bench {

namespace {

/// Numbers of samples that a line is told from.
constexpr std::size_t leastPoints = 3;

BakeGrowth* growthFor(std::vector<BakeGrowth>& growths, const BakeRow& row) {
    const auto found = std::find_if(growths.begin(), growths.end(), [&](const BakeGrowth& growth) {
        return growth.mesh == row.mesh && growth.method == row.method &&
               growth.mapSize == row.mapSize;
    });
    if (found != growths.end()) {
        return &*found;
    }
    growths.push_back({row.mesh, row.triangles, row.method, row.mapSize, 0.0, 0.0, {}});
    return &growths.back();
}

void fitLine(BakeGrowth& growth) {
    double weights = 0.0;
    double x = 0.0;
    double y = 0.0;
    double xx = 0.0;
    double xy = 0.0;
    for (const BakeGrowth::Point& point : growth.points) {
        const double weight = 1.0 / (point.whole * point.whole);
        weights += weight;
        x += weight * point.samples;
        y += weight * point.whole;
        xx += weight * point.samples * point.samples;
        xy += weight * point.samples * point.whole;
    }
    growth.perSample = (weights * xy - x * y) / (weights * xx - x * x);
    growth.once = (y - growth.perSample * x) / weights;
    for (BakeGrowth::Point& point : growth.points) {
        point.growing = point.whole - growth.once;
    }
}

std::string formatted(const char* format, double value) {
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), format, value);
    return text.data();
}

} // namespace

std::vector<BakeGrowth> growthOf(const std::vector<BakeRow>& rows) {
    std::vector<BakeGrowth> growths;
    for (const BakeRow& row : rows) {
        if (row.processor > 0.0) {
            growthFor(growths, row)->points.push_back({row.samples, row.processor, 0.0});
        }
    }
    std::erase_if(growths,
                  [](const BakeGrowth& growth) { return growth.points.size() < leastPoints; });
    for (BakeGrowth& growth : growths) {
        std::sort(growth.points.begin(), growth.points.end(),
                  [](const auto& a, const auto& b) { return a.samples < b.samples; });
        fitLine(growth);
    }
    return growths;
}

std::string growthMarkdown(const std::vector<BakeGrowth>& growths) {
    if (growths.empty()) {
        return {};
    }
    std::string text = "| mesh | map | method | once | per 100 samples | growth of the whole | "
                       "without what is done once |\n|---|---|---|---|---|---|---|\n";
    for (const BakeGrowth& growth : growths) {
        std::string whole;
        std::string growing;
        for (std::size_t i = 1; i < growth.points.size(); ++i) {
            const BakeGrowth::Point& before = growth.points[i - 1];
            const BakeGrowth::Point& point = growth.points[i];
            const std::string step = (i > 1 ? ", " : "") + std::to_string(before.samples) + " to " +
                                     std::to_string(point.samples) + ": ";
            whole += step + formatted("%.2f", point.whole / before.whole);
            growing += (i > 1 ? ", " : "") + formatted("%.2f", point.growing / before.growing);
        }
        text += "| " + growth.mesh + " | " + std::to_string(growth.mapSize) + "^2 | " +
                bakeMethodName(growth.method) + " | " + formatted("%.2f s", growth.once) + " | " +
                formatted("%.2f s", 100.0 * growth.perSample) + " | " + whole + " | " + growing +
                " |\n";
    }
    return text;
}

} // namespace aolib::bench
