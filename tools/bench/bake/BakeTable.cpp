#include "bench/bake/BakeTable.h"

#include <array>
#include <cstdio>
#include <map>
#include <utility>

#include "bench/CsvLine.h"

namespace aolib::bench {

namespace {

std::string fixed(double value, int decimals) {
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), "%.*f", decimals, value);
    return text.data();
}

} // namespace

std::string bakeCsv(const std::vector<BakeRow>& rows) {
    std::string text = "mesh,triangles,method,samples,seconds,rmse_inside,rmse_seams,bias,"
                       "bent_normal_degrees,texels\n";
    for (const BakeRow& row : rows) {
        text += CsvLine()
                    .add(row.mesh)
                    .add(row.triangles)
                    .add(bakeMethodName(row.method))
                    .add(row.samples)
                    .add(row.seconds)
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
    std::string text = "| mesh | triangles | method | samples | seconds | RMSE inside | RMSE at "
                       "seams | bent normal |\n|---|---|---|---|---|---|---|---|\n";
    for (const BakeRow& row : rows) {
        text += "| " + row.mesh + " | " + std::to_string(row.triangles) + " | " +
                bakeMethodName(row.method) + " | " + std::to_string(row.samples) + " | " +
                fixed(row.seconds, 1) + " | " + fixed(row.errors.inside, 4) + " | " +
                fixed(row.errors.seams, 4) + " | " + fixed(row.errors.bentAngle, 1) + "° |\n";
    }
    return text;
}

Plot bakePlot(const std::vector<BakeRow>& rows, const std::string& subtitle) {
    static const std::array<Colour, 4> colours{Colour{31, 119, 180}, Colour{214, 39, 40},
                                               Colour{255, 152, 150}, Colour{44, 160, 44}};
    std::map<std::pair<int, int>, Curve> curves;
    for (const BakeRow& row : rows) {
        const int method = static_cast<int>(row.method);
        Curve& curve = curves[{method, row.samples}];
        curve.name = std::string(bakeMethodName(row.method)) + ", " + std::to_string(row.samples);
        curve.colour = colours[static_cast<std::size_t>(method)];
        curve.points.push_back({double(row.triangles), row.seconds, ""});
    }
    Plot plot;
    plot.title = "Time of a bake";
    plot.subtitle = subtitle;
    plot.x.title = "triangles";
    plot.y.title = "seconds";
    for (auto& [key, curve] : curves) {
        plot.curves.push_back(std::move(curve));
    }
    return plot;
}

} // namespace aolib::bench
