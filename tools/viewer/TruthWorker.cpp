#include "viewer/TruthWorker.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "parallel/CoreCount.h"

namespace aolib::viewer {

namespace {

/// A view that is asked for so long is at rest.
constexpr std::chrono::milliseconds kRest{150};

int workers(int threads) {
    return threads > 0 ? threads : std::max(1, coreCount() - 1);
}

} // namespace

bool TruthRequest::sameView(const TruthRequest& other) const {
    return camera.view == other.camera.view && camera.projection == other.camera.projection &&
           camera.width == other.camera.width && camera.height == other.camera.height &&
           radius == other.radius && falloff == other.falloff && normals == other.normals;
}

TruthWorker::TruthWorker(std::function<void()> wake, int threads)
    : wake_(std::move(wake)), threads_(workers(threads)),
      thread_([this](const std::stop_token& ending) { loop(ending); }) {}

TruthWorker::~TruthWorker() = default;

void TruthWorker::setScene(TriangleMesh mesh) {
    const std::scoped_lock lock(mutex_);
    mesh_ = std::move(mesh);
    request_.reset();
    change();
}

void TruthWorker::follow(const TruthRequest& request) {
    const std::scoped_lock lock(mutex_);
    if (request_ && request_->sameView(request)) {
        if (request_->rays != request.rays) {
            request_->rays = request.rays;
            const int known = state_.truth ? state_.truth->rays : 0;
            state_.working = state_.failure.empty() && known < request.rays;
            changed_.notify_all();
        }
        return;
    }
    request_ = request;
    change();
    state_.working = true;
}

void TruthWorker::stop() {
    const std::scoped_lock lock(mutex_);
    if (request_) {
        request_.reset();
        change();
    }
}

TruthWorker::State TruthWorker::state() const {
    const std::scoped_lock lock(mutex_);
    return state_;
}

void TruthWorker::change() {
    ++generation_;
    state_ = State();
    changed_.notify_all();
}

void TruthWorker::loop(const std::stop_token& ending) {
    std::unique_lock lock(mutex_);
    while (changed_.wait(lock, ending, [this] { return state_.working; }) &&
           !ending.stop_requested()) {
        work(lock, ending);
        lock.unlock();
        wake_();
        lock.lock();
    }
}

/// One step: a pause, the scene, or a pass.
void TruthWorker::work(std::unique_lock<std::mutex>& lock, const std::stop_token& ending) {
    const std::uint64_t generation = generation_;
    if (!state_.truth) {
        average_.clear();
        changed_.wait_for(lock, ending, kRest, [&] { return generation != generation_; });
        if (generation != generation_ || ending.stop_requested()) {
            return;
        }
    }
    if (mesh_) {
        const AoStatus status = buildScene(lock, ending);
        if (!status && generation == generation_) {
            state_.failure = status.message();
            state_.working = false;
        }
        return;
    }
    if (!scene_) {
        state_.working = false;
        return;
    }
    tracePass(lock, ending);
}

AoStatus TruthWorker::buildScene(std::unique_lock<std::mutex>& lock,
                                 const std::stop_token& ending) {
    TriangleMesh mesh = std::move(*mesh_);
    mesh_.reset();
    lock.unlock();
    scene_.reset();
    Result<RayScene> scene =
        RayScene::create(std::move(mesh), [&ending] { return !ending.stop_requested(); });
    lock.lock();
    if (!scene) {
        return scene.status();
    }
    scene_ = std::move(*scene);
    return {};
}

void TruthWorker::tracePass(std::unique_lock<std::mutex>& lock, const std::stop_token& ending) {
    const std::uint64_t generation = generation_;
    const TruthRequest request = *request_;
    const int traced = average_.rays();
    const int pass = raysOfNextPass(traced, request.rays);
    lock.unlock();
    PictureSettings settings;
    settings.trace.rays = pass;
    settings.trace.radius = request.radius;
    settings.trace.falloff = request.falloff;
    settings.trace.threads = threads_;
    settings.trace.seed = static_cast<std::uint64_t>(traced);
    settings.normals = request.normals;
    const auto progress = [&](double fraction) {
        const std::scoped_lock inner(mutex_);
        if (generation == generation_) {
            state_.progress = static_cast<float>((traced + fraction * pass) / request.rays);
        }
        return generation == generation_ && !ending.stop_requested();
    };
    const Result<Picture> picture = tracePicture(*scene_, request.camera, settings, progress);
    auto truth = std::make_shared<TracedTruth>();
    if (picture && picture->complete) {
        average_.add(*picture, pass);
        truth->visibility = average_.visibility();
        truth->rays = average_.rays();
        truth->noise = average_.noise();
    }
    lock.lock();
    if (generation != generation_ || !request_) {
        return;
    }
    if (!picture) {
        state_.failure = picture.status().message();
        state_.working = false;
    } else if (picture->complete) {
        truth->request = *request_;
        state_.truth = std::move(truth);
        state_.working = average_.rays() < request_->rays;
        state_.progress = std::min(1.0F, static_cast<float>(average_.rays()) /
                                             static_cast<float>(request_->rays));
    }
}

} // namespace aolib::viewer
