#include "bench/ThesisFiles.h"

#include "bench/CsvLine.h"
#include "bench/ResultJson.h"
#include "bench/TextFile.h"

namespace aolib::bench {

std::string thesisCsv(const std::vector<ThesisRow>& rows) {
    std::string text = "figure,scene,triangles,estimator,face_size,directions,steps,cube_maps,"
                       "build_ms,build_ms_q1,build_ms_q3,frame_ms,frame_ms_q1,frame_ms_q3,layers,"
                       "bytes_kept,bytes_capture,failure\n";
    for (const ThesisRow& row : rows) {
        const ThesisSetting& s = row.setting;
        CsvLine line;
        line.add(figureName(s.figure)).add(row.scene).add(row.triangles);
        line.add(estimatorName(s.estimator)).add(s.faceSize).add(s.directions).add(s.steps);
        line.add(s.cubeMaps);
        line.addKnown(row.buildMs.median).addKnown(row.buildMs.low).addKnown(row.buildMs.high);
        line.addKnown(row.frameMs.median).addKnown(row.frameMs.low).addKnown(row.frameMs.high);
        line.add(row.layers).add(row.bytesKept).add(row.bytesCapture).add(row.failure);
        text += line.text();
    }
    return text;
}

std::string thesisJson(const ThesisRunSettings& settings, const std::vector<ThesisRow>& rows) {
    Json results = Json::array();
    for (const ThesisRow& row : rows) {
        const ThesisSetting& s = row.setting;
        results.push_back({{"figure", figureName(s.figure)},
                           {"scene", row.scene},
                           {"triangles", row.triangles},
                           {"estimator", estimatorName(s.estimator)},
                           {"face_size", s.faceSize},
                           {"directions", s.directions},
                           {"steps", s.steps},
                           {"cube_maps", s.cubeMaps},
                           {"build_ms", spreadJson(row.buildMs)},
                           {"frame_ms", spreadJson(row.frameMs)},
                           {"layers", row.layers},
                           {"bytes_kept", row.bytesKept},
                           {"bytes_capture", row.bytesCapture},
                           {"failure", row.failure}});
    }
    return fileText({{"machine", machineJson(settings.machine, settings.commandLine)},
                     {"settings",
                      {{"width", settings.size.width},
                       {"height", settings.size.height},
                       {"radius_share", kWideRadius},
                       {"repeat", settings.timing.repeat},
                       {"frames", settings.timing.frames}}},
                     {"results", std::move(results)}});
}

std::string writeThesisFiles(const ThesisRunSettings& settings,
                             const std::vector<ThesisRow>& rows) {
    std::string reason = writeText(settings.out / "thesis.csv", thesisCsv(rows));
    return reason.empty() ? writeText(settings.out / "thesis.json", thesisJson(settings, rows))
                          : reason;
}

} // namespace aolib::bench
