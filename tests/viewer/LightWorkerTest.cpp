#include "viewer/LightWorker.h"

#include <chrono>
#include <condition_variable>
#include <mutex>

#include <gtest/gtest.h>

#include "content/SceneSource.h"

namespace aolib::viewer {
namespace {

bench::LitSceneOptions options(int rays) {
    bench::LitSceneOptions light;
    light.edge = 0.1;
    light.rays = rays;
    return light;
}

/// Hears when a worker has ended.
class Wakes {
public:
    std::function<void()> hear() {
        return [this] {
            const std::scoped_lock lock(mutex_);
            ++count_;
            heard_.notify_all();
        };
    }
    bool wait() {
        std::unique_lock lock(mutex_);
        return heard_.wait_for(lock, std::chrono::seconds(60), [&] { return count_ > 0; });
    }
    int count() const { return count_; }

private:
    std::mutex mutex_;
    std::condition_variable heard_;
    int count_ = 0;
};

TEST(LightWorkerTest, BakesASceneOnceAndForgetsItWhenStopped) {
    const Model model = *openScene("wall");
    Wakes wakes;
    LightWorker worker(wakes.hear(), options(8));
    EXPECT_FALSE(worker.state().working);
    worker.follow(model);
    EXPECT_TRUE(worker.state().working || worker.state().scene);
    ASSERT_TRUE(wakes.wait());
    const LightWorker::State baked = worker.state();
    ASSERT_TRUE(baked.scene) << baked.failure;
    EXPECT_FALSE(baked.working);
    EXPECT_EQ(baked.progress, 1.0F);
    EXPECT_GT(baked.scene->vertices(), model.triangleCount());
    worker.follow(model);
    EXPECT_EQ(worker.state().scene, baked.scene) << "it is baked already";
    worker.stop();
    EXPECT_FALSE(worker.state().scene);
}

TEST(LightWorkerTest, IsStoppedOnItsWay) {
    Wakes wakes;
    LightWorker worker(wakes.hear(), options(1 << 20)); // which would take hours
    worker.follow(*openScene("cornell"));
    worker.stop();
    EXPECT_EQ(wakes.count(), 1);
    EXPECT_FALSE(worker.state().working);
    EXPECT_FALSE(worker.state().scene);
    EXPECT_EQ(worker.state().failure, "");
}

} // namespace
} // namespace aolib::viewer
