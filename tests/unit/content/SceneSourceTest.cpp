#include "content/SceneSource.h"

#include <cstdlib>
#include <fstream>

#include <gtest/gtest.h>

namespace aolib {
namespace {

const std::filesystem::path scenesFolder = std::filesystem::path(AOLIB_TEST_FOLDER) / "scenes";
const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

/// Sets AOLIB_MODELS_DIR for one test and puts it back.
class ModelsDirGuard {
public:
    explicit ModelsDirGuard(const std::string& value) {
        const char* old = std::getenv("AOLIB_MODELS_DIR");
        had_ = old != nullptr;
        old_ = had_ ? old : "";
        setenv("AOLIB_MODELS_DIR", value.c_str(), 1);
    }
    ~ModelsDirGuard() {
        if (had_) {
            setenv("AOLIB_MODELS_DIR", old_.c_str(), 1);
        } else {
            unsetenv("AOLIB_MODELS_DIR");
        }
    }
    ModelsDirGuard(const ModelsDirGuard&) = delete;
    ModelsDirGuard& operator=(const ModelsDirGuard&) = delete;

private:
    bool had_ = false;
    std::string old_;
};

void fillFolder() {
    std::filesystem::create_directories(scenesFolder / "sub.glb");
    for (const char* name : {"b.obj", "a.OBJ", "notes.txt"}) {
        std::ofstream(scenesFolder / name) << triangle;
    }
}

TEST(SceneSourceTest, NamesWinOverFiles) {
    const Result<Model, LoadError> named = openScene("plane");
    ASSERT_TRUE(named.ok()) << named.error().sentence;
    EXPECT_EQ(named->triangleCount(), 2U);
    EXPECT_EQ(camerasFor("plane", *named)[0].name, "oblique");
}

TEST(SceneSourceTest, OpensFiles) {
    fillFolder();
    const std::string path = (scenesFolder / "b.obj").string();
    const Result<Model, LoadError> model = openScene(path);
    ASSERT_TRUE(model.ok()) << model.error().sentence;
    EXPECT_EQ(model->triangleCount(), 1U);
    EXPECT_EQ(camerasFor(path, *model)[0].name, "front right");
}

TEST(SceneSourceTest, SaysWhichNamesThereAre) {
    const Result<Model, LoadError> model = openScene("twon");
    ASSERT_FALSE(model.ok());
    EXPECT_NE(model.error().sentence.find("twon"), std::string::npos);
    EXPECT_NE(model.error().sentence.find("town, room, dome"), std::string::npos)
        << model.error().sentence;
    EXPECT_NE(openScene("gone.obj").error().sentence.find("no such file"), std::string::npos);
}

TEST(SceneSourceTest, FindsModelFilesOnly) {
    fillFolder();
    const std::vector<std::filesystem::path> files = findModels(scenesFolder);
    ASSERT_EQ(files.size(), 2U);
    EXPECT_EQ(files[0].filename(), "a.OBJ");
    EXPECT_EQ(files[1].filename(), "b.obj");
    EXPECT_TRUE(findModels(scenesFolder / "nowhere").empty());
}

TEST(SceneSourceTest, TheEnvironmentNamesTheModelsFolder) {
    fillFolder();
    const ModelsDirGuard guard(scenesFolder.string());
    EXPECT_EQ(defaultModelsDir(), scenesFolder);
    EXPECT_GE(availableModels().size(), 2U);
}

} // namespace
} // namespace aolib
