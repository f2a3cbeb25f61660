#include "bench/ParetoRun.h"

#include <cmath>
#include <optional>
#include <utility>

#include "bench/FacadeRun.h"
#include "bench/FewRaysRun.h"
#include "bench/HostedFrames.h"
#include "bench/SurfaceElementsRun.h"
#include "bench/TimeLeft.h"

namespace aolib::bench {

namespace {

std::string percent(double share) {
    return std::to_string(std::lround(100.0 * share));
}

/// The run, scene by scene.
class Pareto {
public:
    Pareto(const gl::Functions& gl, const ProcAddressLoader& loader, const ParetoSettings& settings,
           const ParetoReports& reports)
        : gl_(gl), loader_(loader), settings_(settings), reports_(reports),
          left_(settings.cases.size(), settings.methods.size() + 1) {} // the last: truths

    Result<std::vector<ParetoRow>, LoadError> run();

private:
    /// All cases of a scene, beginning at `first`. Returns why everything must stop.
    std::string runScene(const std::vector<BenchCase>& cases);
    std::string runCase(const OpenedScene& scene, FacadeRun& facade, const BenchCase& which);
    Measurement measure(const OpenedScene& scene, FacadeRun& facade, const Method& method,
                        const BenchCase& which, const Truth& truth);
    void announce(const std::string& what);
    void leaveOut(const std::vector<BenchCase>& cases, const std::string& reason);

    const gl::Functions& gl_;
    const ProcAddressLoader& loader_;
    const ParetoSettings& settings_;
    const ParetoReports& reports_;
    TimeLeft left_;
    std::vector<ParetoRow> rows_;
};

Result<std::vector<ParetoRow>, LoadError> Pareto::run() {
    std::vector<BenchCase> ofScene;
    for (std::size_t i = 0; i < settings_.cases.size(); ++i) {
        ofScene.push_back(settings_.cases[i]);
        const bool last = i + 1 == settings_.cases.size() ||
                          settings_.cases[i + 1].scene.name != ofScene.front().scene.name;
        if (!last) {
            continue;
        }
        if (const std::string reason = runScene(ofScene); !reason.empty()) {
            return LoadError{reason};
        }
        ofScene.clear();
    }
    if (rows_.empty()) {
        return LoadError{"none of the scenes asked for could be measured"};
    }
    return std::move(rows_);
}

void Pareto::announce(const std::string& what) {
    const std::string left = left_.text();
    reports_.stage(what + (left.empty() ? "" : ", " + left));
    reports_.progress(left_.fraction());
}

void Pareto::leaveOut(const std::vector<BenchCase>& cases, const std::string& reason) {
    reports_.warn("left out: " + reason);
    for (std::size_t i = 0; i < cases.size(); ++i) {
        left_.skipCase();
    }
}

std::string Pareto::runScene(const std::vector<BenchCase>& cases) {
    announce(cases.front().scene.name + ": opening");
    const Result<OpenedScene, LoadError> scene = openBenchScene(cases.front().scene);
    if (!scene) {
        leaveOut(cases, scene.error().sentence);
        return "";
    }
    Result<FacadeRun, LoadError> facade =
        FacadeRun::create(gl_, loader_, *scene, settings_.truth.size);
    if (!facade) {
        leaveOut(cases, facade.error().sentence);
        return "";
    }
    for (const BenchCase& which : cases) {
        if (which.camera >= scene->cameras.size()) {
            leaveOut({which}, scene->entry.name + " has " + std::to_string(scene->cameras.size()) +
                                  " cameras");
            continue;
        }
        if (std::string reason = runCase(*scene, *facade, which); !reason.empty()) {
            return reason;
        }
    }
    return "";
}

std::string Pareto::runCase(const OpenedScene& scene, FacadeRun& facade, const BenchCase& which) {
    ParetoRow row{which, scene.cameras[which.camera].name, {}, 0.0, 0, {}};
    announce(caseName(row) + ": truth");
    const Clock::time_point tracing = Clock::now();
    Result<Truth, LoadError> truth =
        bench::traceTruth(scene, which, settings_.truth, settings_.cache);
    if (!truth) {
        return truth.error().sentence;
    }
    if (truth->receivers.points.empty()) {
        leaveOut({which}, caseName(row) + ": the camera sees nothing");
        return "";
    }
    const Result<std::size_t, LoadError> moved = followPicture(
        scene, which, settings_.truth, facade.drawDepths(scene.cameras[which.camera]), *truth);
    if (!moved) {
        return moved.error().sentence;
    }
    row.truthMoved = *moved;
    left_.done(settings_.methods.size(), millisecondsSince(tracing) / kMsPerSecond);
    row.truthNoise = truth->noise;
    for (std::size_t i = 0; i < settings_.methods.size(); ++i) {
        row.method = settings_.methods[i];
        announce(caseName(row) + ": " + row.method.name);
        const Clock::time_point begin = Clock::now();
        row.measured = measure(scene, facade, row.method, which, *truth);
        left_.done(i, millisecondsSince(begin) / kMsPerSecond);
        if (!row.measured.failure.empty()) {
            reports_.warn(caseName(row) + ", " + row.method.name + ": " + row.measured.failure);
        }
        rows_.push_back(row);
    }
    return reports_.caseDone(rows_);
}

Measurement Pareto::measure(const OpenedScene& scene, FacadeRun& facade, const Method& method,
                            const BenchCase& which, const Truth& truth) {
    if (const auto* how = std::get_if<FacadeMethod>(&method.how)) {
        return facade.measure(*how, which, truth, settings_.timing);
    }
    if (const auto* how = std::get_if<FewRaysMethod>(&method.how)) {
        return measureFewRays(*how, scene, which, truth, settings_.truth.size, settings_.timing);
    }
    return measureSurfaceElements(std::get<SurfaceElementsMethod>(method.how), scene, which, truth,
                                  settings_.truth.size, settings_.timing);
}

} // namespace

std::string caseName(const ParetoRow& row) {
    return row.which.scene.name + ", " + row.camera + ", " + percent(row.which.radiusShare) + "%";
}

std::string caseFileName(const ParetoRow& row) {
    std::string name =
        row.which.scene.name + "-" + row.camera + "-" + percent(row.which.radiusShare);
    for (char& c : name) {
        if (c == ' ' || c == ',' || c == '/') {
            c = '_';
        }
    }
    return name;
}

Result<std::vector<ParetoRow>, LoadError> runPareto(const gl::Functions& gl,
                                                    const ProcAddressLoader& loader,
                                                    const ParetoSettings& settings,
                                                    const ParetoReports& reports) {
    return Pareto(gl, loader, settings, reports).run();
}

} // namespace aolib::bench
