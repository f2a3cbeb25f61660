#include "bench/Truth.h"

#include <fstream>

#include <gtest/gtest.h>

#include "BenchFolder.h"
#include "bench/TruthCache.h"

namespace aolib::bench {
namespace {

const std::vector<float> kW{0.25F, 0.5F, 1.0F};
const std::vector<float> kNoise{0.01F, 0.02F, 0.0F};

TEST(TruthCache, GivesBackWhatItKept) {
    const TruthCache cache(test::freshFolder() / "made");
    EXPECT_EQ(cache.write("key", kW, kNoise), "");
    const auto values = cache.read("key", 3);
    ASSERT_TRUE(values);
    EXPECT_EQ(values->visibility, kW);
    EXPECT_EQ(values->standardError, kNoise);
}

TEST(TruthCache, KnowsOnlyWhatWasAskedFor) {
    const TruthCache cache(test::freshFolder());
    EXPECT_EQ(cache.write("key", kW, kNoise), "");
    EXPECT_FALSE(cache.read("other", 3));
    EXPECT_FALSE(cache.read("key", 2));
    std::filesystem::copy_file(cache.file("key"), cache.file("forged"));
    EXPECT_FALSE(cache.read("forged", 3));
}

TEST(TruthCache, RejectsATruncatedFile) {
    const TruthCache cache(test::freshFolder());
    EXPECT_EQ(cache.write("key", kW, kNoise), "");
    std::filesystem::resize_file(cache.file("key"), 10);
    EXPECT_FALSE(cache.read("key", 3));
}

TEST(TruthCache, SaysWhyItCannotKeep) {
    const std::filesystem::path file = test::freshFolder() / "file";
    std::ofstream(file) << "in the way";
    EXPECT_NE(TruthCache(file).write("key", kW, kNoise).find("file"), std::string::npos);
}

class TruthOfACase : public testing::Test {
protected:
    TruthOfACase() { settings_.size = {48, 27}, settings_.rays = 64; }

    Truth traced(const std::filesystem::path& cache = {}) const {
        Result<Truth, LoadError> truth = traceTruth(*scene_, which_, settings_, cache);
        EXPECT_TRUE(truth) << truth.error().sentence;
        return std::move(*truth);
    }

    Result<OpenedScene, LoadError> scene_ =
        openBenchScene({"cornell", SceneKind::Generated, false});
    BenchCase which_{{"cornell", SceneKind::Generated, false}, 0, 0.1};
    TruthSettings settings_;
};

TEST_F(TruthOfACase, IsTheSameFromTheCache) {
    const std::filesystem::path folder = test::freshFolder();
    const Truth first = traced(folder);
    const Truth second = traced(folder);
    EXPECT_FALSE(first.fromCache);
    EXPECT_TRUE(second.fromCache);
    EXPECT_EQ(first.visibility, second.visibility);
    EXPECT_EQ(first.noise, second.noise);
    EXPECT_GT(first.noise, 0.0);
}

TEST_F(TruthOfACase, HasAKeyOfEverythingItDependsOn) {
    const std::string key = truthKey(*scene_, which_, settings_);
    const auto differs = [&](const BenchCase& which, const TruthSettings& settings) {
        return truthKey(*scene_, which, settings) != key;
    };
    BenchCase wider = which_;
    wider.radiusShare = 0.11;
    EXPECT_TRUE(differs(wider, settings_));
    BenchCase elsewhere = which_;
    elsewhere.camera = 1;
    EXPECT_TRUE(differs(elsewhere, settings_));
    TruthSettings more = settings_;
    more.rays = 65;
    EXPECT_TRUE(differs(which_, more));
    more = settings_;
    more.seed = 2;
    EXPECT_TRUE(differs(which_, more));
    more = settings_;
    more.size.width = 49;
    EXPECT_TRUE(differs(which_, more));
    more = settings_;
    more.stride = 4;
    EXPECT_TRUE(differs(which_, more));
    scene_->fingerprint ^= 1;
    EXPECT_TRUE(differs(which_, settings_));
}

TEST(OpenBenchScene, AddsTheGroundButNotToTheSize) {
    const Result<OpenedScene, LoadError> without =
        openBenchScene({"cornell", SceneKind::Generated, false});
    const Result<OpenedScene, LoadError> with =
        openBenchScene({"cornell", SceneKind::Generated, true});
    ASSERT_TRUE(without && with);
    EXPECT_DOUBLE_EQ(without->diagonal, with->diagonal);
    EXPECT_EQ(without->model.triangleCount() + 2, with->model.triangleCount());
    EXPECT_NE(without->fingerprint, with->fingerprint);
}

TEST(OpenBenchScene, NamesTheMissingModel) {
    const Result<OpenedScene, LoadError> scene =
        openBenchScene({"no_such_model", SceneKind::Model, false});
    ASSERT_FALSE(scene);
    EXPECT_NE(scene.error().sentence.find("no_such_model"), std::string::npos);
    EXPECT_NE(scene.error().sentence.find("AOLIB_MODELS_DIR"), std::string::npos);
}

} // namespace
} // namespace aolib::bench
