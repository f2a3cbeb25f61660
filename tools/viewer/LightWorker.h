#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "bench/environment/LitScene.h"
#include "content/Model.h"

namespace aolib::viewer {

/// Bakes what environment light needs of a scene's vertices, on threads of its own. Threads: all
/// functions from one.
class LightWorker {
public:
    struct State {
        std::shared_ptr<const bench::LitScene> scene; ///< null until it is done
        float progress = 0.0F;                        ///< 0 to 1
        bool working = false;
        std::string failure; ///< why there is none
    };

    /// @param wake  called from another thread when state() has ended to work.
    LightWorker(std::function<void()> wake, const bench::LitSceneOptions& options)
        : wake_(std::move(wake)), options_(options) {}
    ~LightWorker() { stop(); }
    LightWorker(const LightWorker&) = delete;
    LightWorker& operator=(const LightWorker&) = delete;

    /// Bakes this model, unless that was begun or done since the last stop().
    void follow(const Model& model);
    /// Ends what is under way; what is known is forgotten.
    void stop();

    State state() const;

private:
    void work(const std::stop_token& ending, Model model);

    const std::function<void()> wake_;
    const bench::LitSceneOptions options_;
    mutable std::mutex mutex_;
    State state_;
    std::atomic<float> progress_{0.0F};
    std::jthread thread_; ///< last: it ends before the rest goes
};

} // namespace aolib::viewer
