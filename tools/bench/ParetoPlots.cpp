#include "bench/ParetoPlots.h"

#include <algorithm>
#include <system_error>
#include <utility>

#include "bench/FamilyStyle.h"
#include "bench/ParetoSummary.h"
#include "bench/plot/PlotFiles.h"

namespace aolib::bench {

namespace {

constexpr double kPathWidth = 1.2;
constexpr const char* kErrorTitle = "RMSE of W against ray tracing";
constexpr const char* kFrameTitle = "per frame, ms: what a method adds once it has converged";
constexpr const char* kBuildTitle =
    "until converged, ms: from nothing to a picture that no longer changes";

/// A method's place in both plots.
struct Place {
    const Method* method;
    double frameMs;
    double convergedMs;
    double rmse;
    const std::vector<Progressed>* path; ///< may be nullptr
};

std::vector<std::string> notesOf(const ParetoSettings& settings) {
    const MachineInfo& machine = settings.machine;
    const TruthSettings& truth = settings.truth;
    return {machine.driver,
            machine.cpu + ", " + std::to_string(machine.cores) + " logical cores; commit " +
                (machine.commit.empty() ? "unknown" : machine.commit) + "; " + machine.date,
            std::to_string(truth.size.width) + " x " + std::to_string(truth.size.height) +
                " pixels, step falloff, geometric normals; truth: " + std::to_string(truth.rays) +
                " rays at one pixel in " + std::to_string(truth.stride * truth.stride) +
                ", its noise taken off"};
}

Plot plotOf(const ParetoSettings& settings, const std::string& title, const std::string& subtitle,
            const char* xTitle) {
    Plot plot;
    plot.title = title;
    plot.subtitle = subtitle;
    plot.x.title = xTitle;
    plot.y.title = kErrorTitle;
    plot.notes = notesOf(settings);
    return plot;
}

/// Sorts a family's points and parts off those that another one beats in both error and time.
std::vector<PlotPoint> takeBeaten(std::vector<PlotPoint>& points) {
    std::stable_sort(points.begin(), points.end(), [](const PlotPoint& a, const PlotPoint& b) {
        return a.x != b.x ? a.x < b.x : a.y < b.y;
    });
    std::vector<PlotPoint> best;
    std::vector<PlotPoint> beaten;
    for (const PlotPoint& point : points) {
        const bool isBest = best.empty() || point.y < best.back().y;
        (isBest ? best : beaten).push_back(point);
    }
    points = std::move(best);
    return beaten;
}

/// One curve per family through its best methods; those that others of the family beat stand
/// beside it.
void addFamilies(Plot& plot, const std::vector<Place>& places, double Place::*x) {
    for (const Family family : families()) {
        const FamilyStyle style = styleOf(family);
        Curve curve{std::string(familyName(family)),
                    style.colour,
                    style.marker,
                    {},
                    style.width,
                    style.dash,
                    true};
        for (const Place& place : places) {
            if (place.method->family == family) {
                curve.points.push_back({place.*x, place.rmse, place.method->label});
            }
        }
        if (curve.points.empty()) {
            continue;
        }
        Curve beside{"", style.colour, style.marker, takeBeaten(curve.points), 0.0, 0.0, true};
        plot.curves.push_back(std::move(curve));
        if (!beside.points.empty()) {
            plot.curves.push_back(std::move(beside));
        }
    }
}

/// What pictures were worth on the way.
void addPaths(Plot& plot, const std::vector<Place>& places) {
    for (const Place& place : places) {
        if (place.path == nullptr || place.path->size() < 2) {
            continue;
        }
        const FamilyStyle style = styleOf(place.method->family);
        Curve curve{"", style.colour, style.marker, {}, kPathWidth, 0.0, false};
        for (const Progressed& moment : *place.path) {
            curve.points.push_back({moment.ms, moment.rmse, ""});
        }
        plot.curves.push_back(std::move(curve));
    }
}

std::string writeBoth(const ParetoSettings& settings, const std::vector<Place>& places,
                      const std::string& subtitle, const std::filesystem::path& stem) {
    Plot frame = plotOf(settings, "Error against cost per frame", subtitle, kFrameTitle);
    addFamilies(frame, places, &Place::frameMs);
    if (std::string reason = writePlot(frame, stem); !reason.empty()) {
        return reason;
    }
    Plot build = plotOf(settings, "Error against time to build", subtitle, kBuildTitle);
    addFamilies(build, places, &Place::convergedMs);
    addPaths(build, places);
    std::filesystem::path buildStem = stem;
    buildStem += "-build";
    return writePlot(build, buildStem);
}

} // namespace

std::string writeCasePlots(const ParetoSettings& settings, const std::vector<ParetoRow>& rows) {
    const std::string name = caseFileName(rows.back());
    std::vector<Place> places;
    for (const ParetoRow& row : rows) {
        const Measurement& m = row.measured;
        if (caseFileName(row) == name && m.failure.empty()) {
            places.push_back(
                {&row.method, m.frameMs.median, m.convergedMs.median, m.final.rmse, &m.path});
        }
    }
    const std::filesystem::path folder = settings.out / "cases";
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) {
        return folder.string() + ": " + error.message();
    }
    return writeBoth(settings, places, caseName(rows.back()), folder / name);
}

std::string writeMeanPlots(const ParetoSettings& settings, const std::vector<ParetoRow>& rows) {
    const std::vector<MethodSummary> summaries = summarise(rows);
    std::vector<Place> places;
    std::size_t cases = 0;
    for (const MethodSummary& s : summaries) {
        cases = std::max(cases, s.cases);
    }
    for (const MethodSummary& s : summaries) {
        if (s.cases == cases) { // a mean over fewer would be of other cases
            places.push_back({&s.method, s.frameMs, s.convergedMs, s.rmse, nullptr});
        }
    }
    return writeBoth(settings, places,
                     "mean RMSE over " + std::to_string(cases) +
                         " cases (scene x camera x radius), median times",
                     settings.out / "pareto");
}

} // namespace aolib::bench
