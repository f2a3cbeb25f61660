#include "bench/ParetoFiles.h"

#include "bench/CsvLine.h"
#include "bench/ParetoSummary.h"
#include "bench/ResultJson.h"
#include "bench/TextFile.h"

namespace aolib::bench {

namespace {

std::string_view kindName(SceneKind kind) {
    switch (kind) {
    case SceneKind::Generated:
        return "generated";
    case SceneKind::Model:
        return "model";
    case SceneKind::Foliage:
        return "foliage";
    }
    return "";
}

Json toJson(const ErrorFigures& error) {
    return {{"rmse", knownJson(error.rmse)},
            {"bias", error.bias},
            {"p95", knownJson(error.percentile95)},
            {"max", knownJson(error.maximum)},
            {"missing", error.missing},
            {"not_numbers", error.notNumbers}};
}

Json toJson(const std::vector<PassTime>& passes) {
    Json object = Json::object();
    for (const PassTime& time : passes) {
        object[time.pass] = time.ms;
    }
    return object;
}

Json toJson(const ParetoRow& row) {
    const Measurement& m = row.measured;
    Json path = Json::array();
    for (const Progressed& moment : m.path) {
        path.push_back({moment.ms, moment.rmse});
    }
    return {{"scene", row.which.scene.name},
            {"kind", kindName(row.which.scene.kind)},
            {"camera", row.camera},
            {"radius_share", row.which.radiusShare},
            {"method", row.method.name},
            {"family", familyName(row.method.family)},
            {"failure", m.failure},
            {"converged", m.converged},
            {"frame_ms", spreadJson(m.frameMs)},
            {"host_ms", spreadJson(m.hostMs)},
            {"build_ms", spreadJson(m.buildMs)},
            {"converged_ms", spreadJson(m.convergedMs)},
            {"first_ms", knownJson(m.firstMs)},
            {"worst_frame_ms", knownJson(m.worstFrameMs)},
            {"frames_to_converge", m.framesToConverge},
            {"error", toJson(m.final)},
            {"error_first", toJson(m.first)},
            {"coverage", knownJson(m.coverage)},
            {"bytes_kept", m.bytesKept},
            {"bytes_capture", m.bytesCapture},
            {"bytes_frame", m.bytesFrame},
            {"truth_noise", row.truthNoise},
            {"truth_receivers_moved", row.truthMoved},
            {"frame_passes_ms", toJson(m.framePasses)},
            {"build_passes_ms", toJson(m.buildPasses)},
            {"ms_rmse", std::move(path)}};
}

Json toJson(const MethodSummary& s) {
    return {{"method", s.method.name},
            {"cases", s.cases},
            {"failures", s.failures},
            {"rmse", knownJson(s.rmse)},
            {"rmse_without_foliage", knownJson(s.rmseSolid)},
            {"rmse_generated", knownJson(s.rmseGenerated)},
            {"rmse_foliage", knownJson(s.rmseFoliage)},
            {"rmse_worst", knownJson(s.worst)},
            {"rmse_first", knownJson(s.rmseFirst)},
            {"frame_ms", knownJson(s.frameMs)},
            {"frame_ms_q1", knownJson(s.frameMsLow)},
            {"frame_ms_q3", knownJson(s.frameMsHigh)},
            {"build_ms", knownJson(s.buildMs)},
            {"converged_ms", knownJson(s.convergedMs)}};
}

} // namespace

std::string paretoCsv(const std::vector<ParetoRow>& rows) {
    std::string text =
        "scene,kind,camera,radius_percent,method,family,frame_ms,frame_ms_q1,frame_ms_q3,host_ms,"
        "build_ms,build_ms_q1,build_ms_q3,converged_ms,first_ms,worst_frame_ms,frames_to_converge,"
        "converged,rmse,bias,p95,max,rmse_first,coverage,missing,not_numbers,bytes_kept,"
        "bytes_capture,bytes_frame,truth_noise,failure\n";
    for (const ParetoRow& row : rows) {
        const Measurement& m = row.measured;
        CsvLine line;
        line.add(row.which.scene.name).add(kindName(row.which.scene.kind)).add(row.camera);
        line.add(100.0 * row.which.radiusShare).add(row.method.name);
        line.add(familyName(row.method.family));
        line.addKnown(m.frameMs.median).addKnown(m.frameMs.low).addKnown(m.frameMs.high);
        line.addKnown(m.hostMs.median);
        line.addKnown(m.buildMs.median).addKnown(m.buildMs.low).addKnown(m.buildMs.high);
        line.addKnown(m.convergedMs.median).addKnown(m.firstMs).addKnown(m.worstFrameMs);
        line.add(m.framesToConverge).add(m.converged ? 1 : 0);
        line.addKnown(m.final.rmse).add(m.final.bias).addKnown(m.final.percentile95);
        line.addKnown(m.final.maximum).addKnown(m.first.rmse).addKnown(m.coverage);
        line.add(m.final.missing).add(m.final.notNumbers);
        line.add(m.bytesKept).add(m.bytesCapture).add(m.bytesFrame);
        line.add(row.truthNoise).add(m.failure);
        text += line.text();
    }
    return text;
}

std::string paretoJson(const ParetoSettings& settings, const std::vector<ParetoRow>& rows) {
    Json results = Json::array();
    for (const ParetoRow& row : rows) {
        results.push_back(toJson(row));
    }
    Json summary = Json::array();
    for (const MethodSummary& method : summarise(rows)) {
        summary.push_back(toJson(method));
    }
    const Json all{{"machine", machineJson(settings.machine, settings.commandLine)},
                   {"settings",
                    {{"width", settings.truth.size.width},
                     {"height", settings.truth.size.height},
                     {"stride", settings.truth.stride},
                     {"rays", settings.truth.rays},
                     {"seed", settings.truth.seed},
                     {"falloff", "step"},
                     {"normals", "geometric"},
                     {"repeat", settings.timing.repeat},
                     {"frames", settings.timing.frames}}},
                   {"summary", std::move(summary)},
                   {"results", std::move(results)}};
    return fileText(all);
}

std::string writeParetoFiles(const ParetoSettings& settings, const std::vector<ParetoRow>& rows) {
    std::string reason = writeText(settings.out / "pareto.csv", paretoCsv(rows));
    if (reason.empty()) {
        reason = writeText(settings.out / "pareto.json", paretoJson(settings, rows));
    }
    return reason;
}

} // namespace aolib::bench
