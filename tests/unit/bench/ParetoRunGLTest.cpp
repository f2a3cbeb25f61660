#include "bench/ParetoRun.h"

#include <memory>

#include <gtest/gtest.h>

#include "BenchFolder.h"
#include "bench/ParetoFiles.h"
#include "bench/ParetoPlots.h"
#include "platform/GlContext.h"

namespace aolib::bench {
namespace {

Method facade(const std::string& name, Backbone backbone, Estimator estimator, int cubeMaps) {
    FacadeMethod how;
    how.cubeMaps = cubeMaps;
    how.options.backbone = backbone;
    how.options.estimator = estimator;
    how.options.frameBudget = 0.0F;
    how.options.cubeMaps.place = false;
    how.options.cubeMaps.faceSize = 48;
    how.options.cubeMaps.refineStaticViews = false; // else nothing is left to measure
    how.options.layeredIntervals.slices = 4;
    how.options.layeredIntervals.steps = 8;
    Method method;
    method.name = name;
    method.how = how;
    return method;
}

class ParetoRunGL : public testing::Test {
protected:
    void SetUp() override {
        auto context = createOffscreenContext({});
        ASSERT_TRUE(context) << context.status().message();
        context_ = std::move(*context);
        auto gl = gl::Functions::load(context_->loader());
        ASSERT_TRUE(gl) << gl.status().message();
        gl_ = std::make_unique<gl::Functions>(*gl);
        settings_.truth.size = {64, 36};
        settings_.truth.rays = 64;
        settings_.truth.stride = 2;
        settings_.timing.frames = 2;
        settings_.out = test::freshFolder();
        settings_.cache = settings_.out / "truth";
        reports_.stage = [](const std::string&) {};
        reports_.progress = [this](double fraction) { lastFraction_ = fraction; };
        reports_.warn = [this](const std::string& remark) { warnings_.push_back(remark); };
        reports_.caseDone = [this](const std::vector<ParetoRow>&) {
            ++casesDone_;
            return std::string();
        };
    }

    Result<std::vector<ParetoRow>, LoadError> run() {
        return runPareto(*gl_, context_->loader(), settings_, reports_);
    }

    std::unique_ptr<GlContext> context_;
    std::unique_ptr<gl::Functions> gl_;
    ParetoSettings settings_;
    ParetoReports reports_;
    std::vector<std::string> warnings_;
    int casesDone_ = 0;
    double lastFraction_ = -1.0;
};

TEST_F(ParetoRunGL, MeasuresEveryKindOfMethod) {
    settings_.cases = {{{"cornell", SceneKind::Generated, false}, 0, 0.1},
                       {{"cornell", SceneKind::Generated, false}, 1, 0.1}};
    settings_.methods = {
        facade("cube", Backbone::Cubemapped, Estimator::LayeredIntervals, 1),
        facade("cubes", Backbone::Cubemapped, Estimator::HorizonSplit, 3),
        facade("screen", Backbone::ScreenSpace, Estimator::LayeredIntervals, 0),
        {"rays", "rays", Family::FewRays, FewRaysMethod{64}, true},
        {"surfels", "surfels", Family::SurfaceElements, SurfaceElementsMethod{2000}, true}};
    settings_.timing.passes = true;
    const auto rows = run();
    ASSERT_TRUE(rows) << rows.error().sentence;
    ASSERT_EQ(rows->size(), 10U);
    EXPECT_EQ(casesDone_, 2);
    EXPECT_TRUE(warnings_.empty()) << warnings_.front();
    for (const ParetoRow& row : *rows) {
        const Measurement& m = row.measured;
        EXPECT_EQ(m.failure, "") << row.method.name;
        EXPECT_GT(m.final.rmse, 0.0) << row.method.name;
        EXPECT_LT(m.final.rmse, 0.25) << row.method.name;
        EXPECT_LT(m.final.missing, 0.02) << row.method.name;
        EXPECT_GT(m.frameMs.median, 0.0) << row.method.name;
        EXPECT_GE(m.frameMs.count, 2U) << row.method.name;
        EXPECT_TRUE(m.converged) << row.method.name;
        ASSERT_FALSE(m.path.empty()) << row.method.name;
        EXPECT_EQ(m.path.back().rmse, m.final.rmse) << row.method.name;
    }
    const Measurement& cube = (*rows)[0].measured;
    EXPECT_GT(cube.buildMs.median, 0.0);
    // Three bytes per texel of the faces that hold geometry, made room for six at a time, and a
    // page entry of four bytes per tile.
    const std::size_t sixFaces = 6U * (48U * 48U * 3U + 2U * 2U * 4U);
    EXPECT_EQ(cube.bytesKept, sixFaces);
    EXPECT_GE((*rows)[1].measured.bytesKept, sixFaces);
    EXPECT_EQ((*rows)[1].measured.bytesKept % sixFaces, 0U);
    EXPECT_GT(cube.bytesCapture, cube.bytesKept);
    EXPECT_GE(cube.framePasses.size(), 2U);
    EXPECT_GE(cube.buildPasses.size(), 2U);
    EXPECT_EQ((*rows)[2].measured.bytesKept, 0U);
    EXPECT_TRUE((*rows)[2].measured.buildPasses.empty());
    // 64 rays of each pixel have a noise of about 0.14 / sqrt(64).
    EXPECT_LT((*rows)[3].measured.final.rmse, 0.04);
    EXPECT_EQ(writeParetoFiles(settings_, *rows), "");
    EXPECT_EQ(writeCasePlots(settings_, *rows), "");
    EXPECT_EQ(writeMeanPlots(settings_, *rows), "");
    for (const char* file : {"pareto.csv", "pareto.json", "pareto.svg", "pareto-build.png"}) {
        EXPECT_TRUE(std::filesystem::exists(settings_.out / file)) << file;
    }
}

TEST_F(ParetoRunGL, LeavesOutWhatIsAbsent) {
    settings_.cases = {{{"no_such_model", SceneKind::Model, false}, 0, 0.1},
                       {{"plane", SceneKind::Generated, false}, 7, 0.1},
                       {{"plane", SceneKind::Generated, false}, 0, 0.1}};
    settings_.methods = {{"rays", "rays", Family::FewRays, FewRaysMethod{1}, true}};
    const auto rows = run();
    ASSERT_TRUE(rows) << rows.error().sentence;
    EXPECT_EQ(rows->size(), 1U);
    ASSERT_EQ(warnings_.size(), 2U);
    EXPECT_NE(warnings_[0].find("no_such_model"), std::string::npos);
    EXPECT_NE(warnings_[1].find("plane has"), std::string::npos);
}

TEST_F(ParetoRunGL, FailsWhenNothingIsThere) {
    settings_.cases = {{{"no_such_model", SceneKind::Model, false}, 0, 0.1}};
    settings_.methods = {{"rays", "rays", Family::FewRays, FewRaysMethod{1}, true}};
    EXPECT_FALSE(run());
}

TEST_F(ParetoRunGL, KeepsGoingWhenAMethodFails) {
    settings_.cases = {{{"plane", SceneKind::Generated, false}, 0, 0.1}};
    settings_.methods = {facade("bad", Backbone::Cubemapped, Estimator::HorizonSplit, 1),
                         {"rays", "rays", Family::FewRays, FewRaysMethod{4}, true}};
    std::get<FacadeMethod>(settings_.methods[0].how).options.horizonSplit.directions = 9999;
    const auto rows = run();
    ASSERT_TRUE(rows) << rows.error().sentence;
    ASSERT_EQ(rows->size(), 2U);
    EXPECT_NE((*rows)[0].measured.failure, "");
    EXPECT_EQ((*rows)[1].measured.failure, "");
    EXPECT_EQ(warnings_.size(), 1U);
}

TEST_F(ParetoRunGL, StopsWhenResultsCannotBeKept) {
    settings_.cases = {{{"plane", SceneKind::Generated, false}, 0, 0.1}};
    settings_.methods = {{"rays", "rays", Family::FewRays, FewRaysMethod{1}, true}};
    reports_.caseDone = [](const std::vector<ParetoRow>&) { return "the disk is full"; };
    const auto rows = run();
    ASSERT_FALSE(rows);
    EXPECT_EQ(rows.error().sentence, "the disk is full");
}

} // namespace
} // namespace aolib::bench
