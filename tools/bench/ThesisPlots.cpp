#include "bench/ThesisPlots.h"

#include <algorithm>
#include <array>
#include <functional>
#include <utility>

#include "bench/plot/PlotFiles.h"

namespace aolib::bench {

namespace {

constexpr double kMegabyte = 1e6;

/// Colours and markers of curves, in turn.
struct Look {
    Colour colour;
    Marker marker;
};
constexpr std::array<Look, 9> kLooks{{{{0, 90, 181}, Marker::Disc},
                                      {{213, 70, 40}, Marker::Square},
                                      {{0, 135, 90}, Marker::TriangleUp},
                                      {{128, 70, 160}, Marker::Diamond},
                                      {{150, 95, 45}, Marker::TriangleDown},
                                      {{38, 160, 218}, Marker::Ring},
                                      {{110, 150, 40}, Marker::Disc},
                                      {{200, 90, 160}, Marker::Square},
                                      {{90, 90, 90}, Marker::Diamond}}};

using Value = std::function<double(const ThesisRow&)>;

/// One more curve of a plot: the rows that `has` picks, under a name of their own.
Curve curveOf(const std::vector<ThesisRow>& rows, const std::function<bool(const ThesisRow&)>& has,
              const Value& y, const std::string& name, std::size_t number) {
    const Look& look = kLooks[number % kLooks.size()];
    Curve curve{name, look.colour, look.marker, {}, 1.8, 0.0, true};
    for (const ThesisRow& row : rows) {
        if (has(row) && row.failure.empty()) {
            curve.points.push_back({double(row.setting.value()), y(row), ""});
        }
    }
    return curve;
}

/// Scenes and estimators of a figure's rows, each pair once.
std::vector<std::pair<std::string, Estimator>> kindsOf(const std::vector<ThesisRow>& rows,
                                                       ThesisFigure figure) {
    std::vector<std::pair<std::string, Estimator>> kinds;
    for (const ThesisRow& row : rows) {
        const std::pair kind(row.scene, row.setting.estimator);
        if (row.setting.figure == figure &&
            std::find(kinds.begin(), kinds.end(), kind) == kinds.end()) {
            kinds.push_back(kind);
        }
    }
    return kinds;
}

Plot plotOf(const ThesisRunSettings& settings, ThesisFigure figure, const std::string& title) {
    const MachineInfo& machine = settings.machine;
    Plot plot;
    plot.title = title;
    plot.x = {std::string(figureAxis(figure)), false};
    plot.y.logarithmic = false;
    plot.notes = {machine.driver,
                  machine.cpu + ", " + std::to_string(machine.cores) + " logical cores; commit " +
                      (machine.commit.empty() ? "unknown" : machine.commit) + "; " + machine.date,
                  "radius 10% of the scene's diagonal; medians of " +
                      std::to_string(settings.timing.repeat) + " builds and " +
                      std::to_string(settings.timing.repeat * settings.timing.frames) +
                      " frames of " + std::to_string(settings.size.width) + " x " +
                      std::to_string(settings.size.height) + " pixels"};
    return plot;
}

std::string writeTimes(const ThesisRunSettings& settings, const std::vector<ThesisRow>& rows,
                       ThesisFigure figure) {
    const auto kinds = kindsOf(rows, figure);
    if (kinds.empty()) {
        return "";
    }
    const bool frames = figure == ThesisFigure::CubeMaps;
    Plot plot = plotOf(settings, figure,
                       frames ? "Time per frame over cube maps"
                              : "Time to build a cube map over " + std::string(figureName(figure)));
    plot.y.title = frames ? "per frame, ms" : "build of one cube map, ms";
    const Value y = [frames](const ThesisRow& row) {
        return frames ? row.frameMs.median : row.buildMs.median;
    };
    for (const auto& [scene, estimator] : kinds) {
        const auto has = [&, s = scene, e = estimator](const ThesisRow& row) {
            return row.setting.figure == figure && row.scene == s && row.setting.estimator == e;
        };
        plot.curves.push_back(curveOf(rows, has, y,
                                      scene + ", " + std::string(estimatorName(estimator)),
                                      plot.curves.size()));
    }
    return writePlot(plot, settings.out / ("thesis-" + std::string(figureName(figure))));
}

std::string writeMemory(const ThesisRunSettings& settings, const std::vector<ThesisRow>& rows) {
    const auto kinds = kindsOf(rows, ThesisFigure::FaceSize);
    if (kinds.empty()) {
        return "";
    }
    Plot plot = plotOf(settings, ThesisFigure::FaceSize, "GPU memory of a cube map over face size");
    plot.subtitle = "as allocated: taken while it is built and given back, and kept";
    plot.y = {"megabytes", true};
    for (const auto& [scene, estimator] : kinds) {
        const auto has = [s = scene, e = estimator](const ThesisRow& row) {
            return row.setting.figure == ThesisFigure::FaceSize && row.scene == s &&
                   row.setting.estimator == e;
        };
        const std::string name = scene + ", " + std::string(estimatorName(estimator));
        plot.curves.push_back(curveOf(
            rows, has, [](const ThesisRow& r) { return double(r.bytesCapture) / kMegabyte; },
            name + ", temporary", plot.curves.size()));
        plot.curves.push_back(curveOf(
            rows, has, [](const ThesisRow& r) { return double(r.bytesKept) / kMegabyte; },
            name + ", kept", plot.curves.size()));
        plot.curves.back().dash = 5.0;
    }
    return writePlot(plot, settings.out / "thesis-memory");
}

} // namespace

std::string writeThesisPlots(const ThesisRunSettings& settings,
                             const std::vector<ThesisRow>& rows) {
    for (const ThesisFigure figure : thesisFigures()) {
        if (std::string reason = writeTimes(settings, rows, figure); !reason.empty()) {
            return reason;
        }
    }
    return writeMemory(settings, rows);
}

} // namespace aolib::bench
