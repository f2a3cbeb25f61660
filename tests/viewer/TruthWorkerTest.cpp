#include <gtest/gtest.h>

#include <chrono>
#include <condition_variable>
#include <mutex>

#include <glm/geometric.hpp>

#include "content/SceneSource.h"
#include "viewer/TruthWorker.h"
#include "viewer/ViewError.h"

namespace aolib::viewer {
namespace {

constexpr std::chrono::seconds kPatience{60};

class TruthWorkerTest : public testing::Test {
protected:
    TruthWorkerTest()
        : model(*openScene("wall")), worker([this] {
              const std::scoped_lock lock(mutex);
              ++calls;
              called.notify_all();
          }) {
        worker.setScene(model.flattened());
    }

    TruthRequest request(int rays, float eyeHeight = 1.0F) const {
        NamedCamera camera = camerasFor("wall", model).front();
        camera.eye.y *= eyeHeight;
        TruthRequest wanted;
        wanted.camera = {glm::dmat4(viewMatrix(camera)), glm::dmat4(projectionMatrix(camera, 1.5F)),
                         48, 32};
        wanted.radius = 100.0;
        wanted.rays = rays;
        return wanted;
    }

    /// Waits until a state is what it should be.
    template <typename Condition>
    bool reaches(Condition condition) {
        std::unique_lock lock(mutex);
        return called.wait_for(lock, kPatience, [&] { return condition(worker.state()); });
    }

    Model model;
    std::mutex mutex;
    std::condition_variable called;
    int calls = 0;
    TruthWorker worker;
};

TEST_F(TruthWorkerTest, GetsBetterUntilItIsDone) {
    worker.follow(request(64));
    EXPECT_TRUE(worker.state().working);
    ASSERT_TRUE(reaches([](const auto& state) { return state.truth && !state.working; }));
    const TruthWorker::State state = worker.state();
    EXPECT_EQ(state.truth->rays, 64);
    EXPECT_EQ(state.progress, 1.0F);
    EXPECT_GT(calls, 3) << "it should tell after each pass";
    // As good as one trace of so many rays, and of the same.
    PictureSettings settings;
    settings.trace.rays = 512;
    settings.trace.radius = 100.0;
    const Result<RayScene> scene = RayScene::create(model.flattened());
    const Result<Picture> picture = tracePicture(*scene, request(64).camera, settings);
    FloatImage expected(48, 32, 1);
    expected.pixels = picture->visibility;
    const auto error = viewError(state.truth->visibility, expected, 0.0);
    ASSERT_TRUE(error);
    EXPECT_NEAR(error->rmse, std::hypot(state.truth->noise, picture->noise), 0.3 * error->rmse);
    EXPECT_LT(std::abs(error->bias), 0.004);
}

TEST_F(TruthWorkerTest, AnotherViewBeginsAnew) {
    worker.follow(request(1 << 20));
    ASSERT_TRUE(reaches([](const auto& state) { return state.truth != nullptr; }));
    worker.follow(request(16, 1.5F));
    EXPECT_EQ(worker.state().truth, nullptr);
    ASSERT_TRUE(reaches([](const auto& state) { return state.truth && !state.working; }));
    EXPECT_TRUE(worker.state().truth->request.sameView(request(16, 1.5F)));
}

TEST_F(TruthWorkerTest, MoreRaysGoOnWhereItWas) {
    worker.follow(request(16));
    ASSERT_TRUE(reaches([](const auto& state) { return state.truth && !state.working; }));
    const auto before = worker.state().truth;
    worker.follow(request(16));
    EXPECT_EQ(worker.state().truth, before) << "the same is not traced again";
    worker.follow(request(40));
    EXPECT_EQ(worker.state().truth, before) << "what is known stays";
    ASSERT_TRUE(reaches([](const auto& state) { return state.truth && !state.working; }));
    EXPECT_GE(worker.state().truth->rays, 40);
}

TEST_F(TruthWorkerTest, StopForgets) {
    worker.follow(request(1 << 20));
    worker.stop();
    EXPECT_FALSE(worker.state().working);
    EXPECT_EQ(worker.state().truth, nullptr);
}

TEST_F(TruthWorkerTest, EndsInTheMiddleOfALongTrace) {
    worker.follow(request(1 << 20));
    ASSERT_TRUE(reaches([](const auto& state) { return state.truth != nullptr; }));
    // The destructor must not wait for a million rays a pixel: the test's own limit would end it.
}

TEST_F(TruthWorkerTest, SaysWhyItCannot) {
    TruthRequest wanted = request(16);
    wanted.radius = -1.0;
    worker.follow(wanted);
    ASSERT_TRUE(reaches([](const auto& state) { return !state.working; }));
    EXPECT_NE(worker.state().failure.find("radius"), std::string::npos) << worker.state().failure;
}

} // namespace
} // namespace aolib::viewer
