#include "bench/ParetoFiles.h"

#include <nlohmann/json.hpp>

#include "bench/CsvLine.h"
#include "bench/ParetoSummary.h"
#include "bench/TextFile.h"

namespace aolib::bench {

namespace {

using Json = nlohmann::ordered_json;

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

Json known(double value) {
    return value >= 0.0 ? Json(value) : Json(nullptr);
}

Json toJson(const Spread& spread) {
    return {{"median", known(spread.median)},
            {"q1", known(spread.low)},
            {"q3", known(spread.high)},
            {"count", spread.count}};
}

Json toJson(const ErrorFigures& error) {
    return {{"rmse", known(error.rmse)},        {"bias", error.bias},
            {"p95", known(error.percentile95)}, {"max", known(error.maximum)},
            {"missing", error.missing},         {"not_numbers", error.notNumbers}};
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
            {"frame_ms", toJson(m.frameMs)},
            {"host_ms", toJson(m.hostMs)},
            {"build_ms", toJson(m.buildMs)},
            {"converged_ms", toJson(m.convergedMs)},
            {"first_ms", known(m.firstMs)},
            {"worst_frame_ms", known(m.worstFrameMs)},
            {"frames_to_converge", m.framesToConverge},
            {"error", toJson(m.final)},
            {"error_first", toJson(m.first)},
            {"coverage", known(m.coverage)},
            {"bytes_kept", m.bytesKept},
            {"bytes_capture", m.bytesCapture},
            {"bytes_frame", m.bytesFrame},
            {"truth_noise", row.truthNoise},
            {"ms_rmse", std::move(path)}};
}

Json toJson(const MethodSummary& s) {
    return {{"method", s.method.name},
            {"cases", s.cases},
            {"failures", s.failures},
            {"rmse", known(s.rmse)},
            {"rmse_without_foliage", known(s.rmseSolid)},
            {"rmse_generated", known(s.rmseGenerated)},
            {"rmse_foliage", known(s.rmseFoliage)},
            {"rmse_worst", known(s.worst)},
            {"rmse_first", known(s.rmseFirst)},
            {"frame_ms", known(s.frameMs)},
            {"frame_ms_q1", known(s.frameMsLow)},
            {"frame_ms_q3", known(s.frameMsHigh)},
            {"build_ms", known(s.buildMs)},
            {"converged_ms", known(s.convergedMs)}};
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
    const MachineInfo& machine = settings.machine;
    const Json all{{"machine",
                    {{"cpu", machine.cpu},
                     {"cores", machine.cores},
                     {"driver", machine.driver},
                     {"commit", machine.commit},
                     {"date", machine.date},
                     {"command", settings.commandLine}}},
                   {"settings",
                    {{"width", settings.truth.size.width},
                     {"height", settings.truth.size.height},
                     {"stride", settings.truth.stride},
                     {"rays", settings.truth.rays},
                     {"seed", settings.truth.seed},
                     {"falloff", "step"},
                     {"normals", "geometric"},
                     {"repeat", settings.patience.repeat},
                     {"frames", settings.patience.frames}}},
                   {"summary", std::move(summary)},
                   {"results", std::move(results)}};
    return all.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string writeParetoFiles(const ParetoSettings& settings, const std::vector<ParetoRow>& rows) {
    std::string reason = writeText(settings.out / "pareto.csv", paretoCsv(rows));
    if (reason.empty()) {
        reason = writeText(settings.out / "pareto.json", paretoJson(settings, rows));
    }
    return reason;
}

} // namespace aolib::bench
