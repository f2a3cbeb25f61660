#include "bench/ThesisRun.h"

#include <memory>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "BenchFolder.h"
#include "bench/ThesisFiles.h"
#include "bench/ThesisPlots.h"
#include "platform/GlContext.h"

namespace aolib::bench {
namespace {

ThesisSetting setting(ThesisFigure figure, Estimator estimator, int faceSize, int cubeMaps) {
    ThesisSetting result;
    result.figure = figure;
    result.estimator = estimator;
    result.faceSize = faceSize;
    result.directions = 4;
    result.steps = 4;
    result.cubeMaps = cubeMaps;
    return result;
}

TEST(ThesisRunGL, MeasuresTimesAndMemory) {
    const auto context = createOffscreenContext({});
    ASSERT_TRUE(context) << context.status().message();
    const auto gl = gl::Functions::load((*context)->loader());
    ASSERT_TRUE(gl) << gl.status().message();
    ThesisRunSettings settings;
    settings.scenes = {{"no_such_model", SceneKind::Model, false},
                       {"cornell", SceneKind::Generated, false}};
    settings.settings = {
        setting(ThesisFigure::FaceSize, Estimator::HorizonSplit, 16, 1),
        setting(ThesisFigure::FaceSize, Estimator::HorizonSplit, 32, 1),
        setting(ThesisFigure::FaceSize, Estimator::LayeredIntervals, 32, 1),
        setting(ThesisFigure::CubeMaps, Estimator::HorizonSplit, 16, 3),
    };
    settings.size = {32, 18};
    settings.timing.frames = 2;
    settings.out = test::freshFolder();
    int warnings = 0;
    ThesisReports reports;
    reports.stage = [](const std::string&) {};
    reports.progress = [](double) {};
    reports.warn = [&](const std::string&) { ++warnings; };
    reports.sceneDone = [&](const std::vector<ThesisRow>& rows) {
        const std::string reason = writeThesisFiles(settings, rows);
        return reason.empty() ? writeThesisPlots(settings, rows) : reason;
    };
    const auto rows = runThesis(*gl, (*context)->loader(), settings, reports);
    ASSERT_TRUE(rows) << rows.error().sentence;
    EXPECT_EQ(warnings, 1);
    ASSERT_EQ(rows->size(), 4U);
    for (const ThesisRow& row : *rows) {
        EXPECT_EQ(row.failure, "");
        EXPECT_GT(row.buildMs.median, 0.0);
        EXPECT_GT(row.frameMs.median, 0.0);
        const auto size = static_cast<std::size_t>(row.setting.faceSize);
        // Faces that hold geometry alone.
        EXPECT_GT(row.bytesKept, 0U);
        EXPECT_LE(row.bytesKept, 6U * size * size * 3U);
    }
    EXPECT_EQ((*rows)[1].bytesCapture, 4U * (*rows)[0].bytesCapture);
    EXPECT_GT((*rows)[2].bytesCapture, (*rows)[2].bytesKept); // of the faces that hold geometry
    const nlohmann::json json = nlohmann::json::parse(thesisJson(settings, *rows));
    EXPECT_EQ(json["results"].size(), 4U);
    for (const char* file :
         {"thesis.csv", "thesis-face-size.svg", "thesis-memory.png", "thesis-cube-maps.svg"}) {
        EXPECT_TRUE(std::filesystem::exists(settings.out / file)) << file;
    }
    EXPECT_FALSE(std::filesystem::exists(settings.out / "thesis-steps.svg"));
}

} // namespace
} // namespace aolib::bench
