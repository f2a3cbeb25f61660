#include "bench/bake/BakeTable.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <utility>

#include "bench/CsvLine.h"

namespace aolib::bench {

namespace {

std::string fixed(double value, int decimals) {
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), "%.*f", decimals, value);
    return text.data();
}

/// McGraw and Sowers 2008, table 1: seconds of a GeForce 8800 GTX for maps of 1024^2.
struct PaperRow {
    int triangles;
    double scatter512;
    double shadow512;
    double scatter1024;
    double shadow1024;
};
constexpr std::array<PaperRow, 7> paperTable{{
    {14998, 5.9, 11.2, 11.3, 20.7},
    {20088, 5.9, 11.1, 11.8, 18.5},
    {63012, 6.2, 11.3, 12.3, 22.6},
    {84638, 6.7, 11.6, 12.1, 23.4},
    {290656, 7.3, 19.6, 14.6, 39.3},
    {588032, 8.5, 38.8, 16.9, 77.0},
    {654666, 9.3, 40.5, 18.7, 81.2},
}};

Colour colourOf(BakeMethodName method) {
    static const std::array<Colour, 4> colours{Colour{31, 119, 180}, Colour{214, 39, 40},
                                               Colour{255, 152, 150}, Colour{44, 160, 44}};
    return colours[static_cast<std::size_t>(method)];
}

/// The fewest samples are discs.
Marker markerOf(std::size_t place) {
    constexpr std::array<Marker, 4> markers{Marker::Disc, Marker::Square, Marker::Diamond,
                                            Marker::TriangleUp};
    return markers[std::min(place, markers.size() - 1)];
}

void addPaperCurves(int samples, Marker marker, std::vector<Curve>& curves) {
    if (samples != 512 && samples != 1024) {
        return;
    }
    const std::string end = ", " + std::to_string(samples) + " (2008, on a card)";
    Curve scatter{
        "McGraw and Sowers: scatter" + end, colourOf(BakeMethodName::Scatter), marker, {}};
    Curve shadow{"McGraw and Sowers: shadow" + end, colourOf(BakeMethodName::Shadow), marker, {}};
    scatter.dash = shadow.dash = 6.0;
    for (const PaperRow& row : paperTable) {
        scatter.points.push_back(
            {double(row.triangles), samples == 512 ? row.scatter512 : row.scatter1024, ""});
        shadow.points.push_back(
            {double(row.triangles), samples == 512 ? row.shadow512 : row.shadow1024, ""});
    }
    curves.push_back(std::move(scatter));
    curves.push_back(std::move(shadow));
}

bool parseMethod(const std::string& name, BakeMethodName& method) {
    for (const BakeMethodName known :
         {BakeMethodName::Rays, BakeMethodName::Scatter, BakeMethodName::ScatterUnstretched,
          BakeMethodName::Shadow}) {
        if (name == bakeMethodName(known)) {
            method = known;
            return true;
        }
    }
    return false;
}

} // namespace

std::string bakeCsv(const std::vector<BakeRow>& rows) {
    std::string text =
        "mesh,triangles,map,method,samples,seconds,processor_seconds,rmse_inside,rmse_seams,bias,"
        "bent_normal_degrees,texels\n";
    for (const BakeRow& row : rows) {
        text += CsvLine()
                    .add(row.mesh)
                    .add(row.triangles)
                    .add(row.mapSize)
                    .add(bakeMethodName(row.method))
                    .add(row.samples)
                    .add(row.seconds)
                    .add(row.processor)
                    .add(row.errors.inside)
                    .add(row.errors.seams)
                    .add(row.errors.bias)
                    .add(row.errors.bentAngle)
                    .add(row.errors.compared)
                    .text();
    }
    return text;
}

std::string bakeMarkdown(const std::vector<BakeRow>& rows) {
    std::string text =
        "| mesh | triangles | map | method | samples | seconds | of processor time | "
        "RMSE inside | RMSE at seams | bent normal |\n"
        "|---|---|---|---|---|---|---|---|---|---|\n";
    for (const BakeRow& row : rows) {
        text += "| " + row.mesh + " | " + std::to_string(row.triangles) + " | " +
                std::to_string(row.mapSize) + "^2 | " + bakeMethodName(row.method) + " | " +
                std::to_string(row.samples) + " | " + fixed(row.seconds, 1) + " | " +
                fixed(row.processor, 1) + " | " + fixed(row.errors.inside, 4) + " | " +
                fixed(row.errors.seams, 4) + " | " + fixed(row.errors.bentAngle, 1) + "° |\n";
    }
    return text;
}

std::vector<BakeRow> rowsOfBakeCsv(const std::string& text) {
    std::vector<BakeRow> rows;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream fields(line);
        std::vector<std::string> values;
        for (std::string value; std::getline(fields, value, ',');) {
            values.push_back(value);
        }
        BakeRow row;
        const auto number = [&](std::size_t i) { return std::strtod(values[i].c_str(), nullptr); };
        if (values.size() != 12 || !parseMethod(values[3], row.method)) {
            continue;
        }
        row.mesh = values[0];
        row.triangles = static_cast<std::size_t>(number(1));
        row.mapSize = static_cast<int>(number(2));
        row.samples = static_cast<int>(number(4));
        row.seconds = number(5);
        row.processor = number(6);
        row.errors = {number(7), number(8), number(9), number(10), static_cast<int>(number(11))};
        rows.push_back(std::move(row));
    }
    return rows;
}

Plot bakePlot(const std::vector<BakeRow>& rows, const std::string& subtitle) {
    std::set<int> samples;
    for (const BakeRow& row : rows) {
        samples.insert(row.samples);
    }
    const auto marker = [&](int count) {
        return markerOf(
            static_cast<std::size_t>(std::distance(samples.begin(), samples.find(count))));
    };
    std::map<std::pair<int, int>, Curve> curves;
    for (const BakeRow& row : rows) {
        const int method = static_cast<int>(row.method);
        Curve& curve = curves[{method, row.samples}];
        curve.name = std::string(bakeMethodName(row.method)) + ", " + std::to_string(row.samples);
        curve.colour = colourOf(row.method);
        curve.marker = marker(row.samples);
        curve.points.push_back({double(row.triangles), row.processor, ""});
    }
    Plot plot;
    plot.title = "Processor time of a bake";
    plot.subtitle = subtitle;
    plot.x.title = "triangles";
    plot.y.title = "seconds";
    for (auto& [key, curve] : curves) {
        std::sort(curve.points.begin(), curve.points.end(),
                  [](const PlotPoint& a, const PlotPoint& b) { return a.x < b.x; });
        plot.curves.push_back(std::move(curve));
    }
    for (const int count : samples) {
        addPaperCurves(count, marker(count), plot.curves);
    }
    return plot;
}

} // namespace aolib::bench
