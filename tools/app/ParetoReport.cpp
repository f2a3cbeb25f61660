#include "app/ParetoReport.h"

#include <iostream>
#include <string>

#include "app/Table.h"
#include "bench/CaseTable.h"
#include "bench/MethodTable.h"
#include "bench/ParetoSummary.h"

namespace aolib::app {

namespace {

std::string spreadText(double median, double low, double high) {
    return knownNumber(median, 1) + " (" + knownNumber(low, 1) + "-" + knownNumber(high, 1) + ")";
}

/// "geometry buffer 8.1, blur 21.0"
std::string passesText(const std::vector<bench::PassTime>& passes) {
    std::string text;
    for (const bench::PassTime& time : passes) {
        text += (text.empty() ? "" : ", ") + time.pass + " " + knownNumber(time.ms, 1);
    }
    return text;
}

} // namespace

void printLists() {
    Table scenes({"scene", "kind"});
    for (const bench::BenchScene& scene : bench::benchScenes()) {
        const bool generated = scene.kind == bench::SceneKind::Generated;
        scenes.add({scene.name, generated ? "generated" : "model"});
    }
    Table methods({"method", "run by default"});
    std::vector<std::string> remarks{"family"};
    for (const bench::Method& method : bench::benchMethods()) {
        methods.add({method.name, method.standard ? "yes" : "no"});
        remarks.emplace_back(bench::familyName(method.family));
    }
    std::cout << scenes.text() << '\n' << methods.text(remarks);
}

void printSummary(const std::vector<bench::ParetoRow>& rows) {
    Table table({"method", "cases", "RMSE", "worst", "no foliage", "generated", "foliage",
                 "first frame", "frame ms (quartiles)", "build ms"});
    for (const bench::MethodSummary& s : bench::summarise(rows)) {
        table.add({s.method.name,
                   std::to_string(s.cases) +
                       (s.failures > 0 ? " of " + std::to_string(s.cases + s.failures) : ""),
                   knownNumber(s.rmse, 4), knownNumber(s.worst, 4), knownNumber(s.rmseSolid, 4),
                   knownNumber(s.rmseGenerated, 4), knownNumber(s.rmseFoliage, 4),
                   knownNumber(s.rmseFirst, 4), spreadText(s.frameMs, s.frameMsLow, s.frameMsHigh),
                   knownNumber(s.buildMs, 0)});
    }
    std::cout << table.text()
              << "RMSE of W against ray tracing, converged, its noise taken off: mean over cases.\n"
                 "Frame: what the method adds to a frame once converged, median over cases. Build: "
                 "until\nconverged, mean over cases.\n";
}

void printPasses(const std::vector<bench::ParetoRow>& rows) {
    std::cout << "\nPasses, ms, medians over cases:\n";
    for (const bench::MethodSummary& s : bench::summarise(rows)) {
        std::vector<std::vector<bench::PassTime>> frames;
        std::vector<std::vector<bench::PassTime>> builds;
        for (const bench::ParetoRow& row : rows) {
            if (row.method.name == s.method.name && row.measured.failure.empty()) {
                frames.push_back(row.measured.framePasses);
                builds.push_back(row.measured.buildPasses);
            }
        }
        const std::string frame = passesText(bench::medianPasses(frames));
        const std::string build = passesText(bench::medianPasses(builds));
        std::cout << (frame.empty() ? "" : s.method.name + ", frame: " + frame + "\n")
                  << (build.empty() ? "" : s.method.name + ", build: " + build + "\n");
    }
}

} // namespace aolib::app
