#include "viewer/LightWorker.h"

#include <exception>
#include <utility>

namespace aolib::viewer {

void LightWorker::follow(const Model& model) {
    const std::lock_guard lock(mutex_);
    if (state_.working || state_.scene || !state_.failure.empty()) {
        return;
    }
    state_.working = true;
    progress_ = 0.0F;
    thread_ = std::jthread([this, copy = model](const std::stop_token& ending) mutable {
        work(ending, std::move(copy));
    });
}

void LightWorker::stop() {
    thread_ = {}; // asks it to end, and waits
    const std::lock_guard lock(mutex_);
    state_ = {};
}

void LightWorker::work(const std::stop_token& ending, Model model) {
    std::shared_ptr<const bench::LitScene> scene;
    std::string failure;
    try {
        auto baked = bench::bakeLitScene(std::move(model), options_, [&](double done) {
            progress_ = static_cast<float>(done);
            return !ending.stop_requested();
        });
        if (baked) {
            scene = std::make_shared<const bench::LitScene>(std::move(*baked));
        } else {
            failure = baked.status().message();
        }
    } catch (const std::exception& error) {
        failure = error.what();
    }
    {
        const std::lock_guard lock(mutex_);
        state_ = {std::move(scene), 1.0F, false, std::move(failure)};
    }
    wake_();
}

LightWorker::State LightWorker::state() const {
    const std::lock_guard lock(mutex_);
    State state = state_;
    if (state.working) {
        state.progress = progress_;
    }
    return state;
}

} // namespace aolib::viewer
