#include "raytracing/TexelTracer.h"

#include <algorithm>
#include <chrono>
#include <functional>
#include <iterator>
#include <new>
#include <utility>

#include "raytracing/RequestTracer.h"

namespace aolib {

namespace {

/// The longest time that `wait()` waits, whatever it is told: about eleven days.
constexpr double longestWait = 1e9;

/// Short enough to need no memory itself.
AoStatus outOfMemory() {
    return {StatusCode::OutOfMemory, "out of memory"};
}

} // namespace

TexelTracer::TexelTracer(int threads) : threads_(static_cast<std::size_t>(threads)) {}

TexelTracer::~TexelTracer() {
    std::ranges::for_each(workers_, [](std::jthread& worker) { worker.request_stop(); });
}

void TexelTracer::setScene(std::vector<glm::vec3> positions, std::vector<std::uint32_t> indices,
                           std::vector<glm::vec3> normals) {
    // What is dropped is destroyed after the lock is released.
    std::deque<TexelRequest> queue;
    std::deque<TracedTexels> finished;
    const std::scoped_lock lock(mutex_);
    ++epoch_;
    queue_.swap(queue);
    finished_.swap(finished);
    begun_ = 0;
    building_ = false;
    status_ = {};
    mesh_ = TriangleMesh{std::move(positions), std::move(normals), std::move(indices)};
    startWorkers(1);
    work_.notify_one();
    changed_.notify_all();
}

void TexelTracer::request(std::vector<TexelRequest> queue) {
    const std::scoped_lock lock(mutex_);
    try {
        queue_.clear();
        if (!mesh_ && !building_ && !scene_) {
            if (!queue.empty()) {
                fail({StatusCode::NoScene, "requests for texels before setScene()"});
            }
        } else {
            std::ranges::copy_if(queue, std::back_inserter(queue_), [this](const auto& request) {
                AoStatus status = checkRequest(request);
                const bool valid = status.ok();
                fail(std::move(status));
                return valid;
            });
            startWorkers(std::min(threads_, queue_.size()));
        }
    } catch (const std::bad_alloc&) {
        fail(outOfMemory());
    }
    work_.notify_all();
    changed_.notify_all();
}

std::vector<TracedTexels> TexelTracer::take(std::size_t most) {
    const std::scoped_lock lock(mutex_);
    const std::size_t count = std::min(most, finished_.size());
    std::vector<TracedTexels> taken;
    try {
        taken.reserve(count);
    } catch (const std::bad_alloc&) {
        fail(outOfMemory());
        return taken;
    }
    const auto end = finished_.begin() + static_cast<std::ptrdiff_t>(count);
    std::move(finished_.begin(), end, std::back_inserter(taken));
    finished_.erase(finished_.begin(), end);
    return taken;
}

bool TexelTracer::wait(double milliseconds) {
    const double limit = milliseconds > 0.0 ? std::min(milliseconds, longestWait) : 0.0;
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, std::chrono::duration<double, std::milli>(limit),
                             [this] { return !finished_.empty() || idle(); });
}

std::size_t TexelTracer::pending() const {
    const std::scoped_lock lock(mutex_);
    return queue_.size() + begun_ + finished_.size();
}

AoStatus TexelTracer::status() const {
    const std::scoped_lock lock(mutex_);
    return status_;
}

/// Keeps the first failure. Under the lock.
void TexelTracer::fail(AoStatus status) {
    if (status_.ok()) {
        status_ = std::move(status);
    }
}

/// Under the lock. Fewer workers than wanted do the work as well, if later.
void TexelTracer::startWorkers(std::size_t count) {
    try {
        while (workers_.size() < count) {
            workers_.emplace_back([this](const std::stop_token& stop) { work(stop); });
        }
    } catch (const std::exception&) {
        if (workers_.empty()) {
            queue_.clear();
            mesh_.reset();
            fail(outOfMemory());
        }
    }
}

bool TexelTracer::somethingToDo() const {
    return mesh_ || (scene_ && !queue_.empty());
}

void TexelTracer::work(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    while (work_.wait(lock, stop, [this] { return somethingToDo(); }) && !stop.stop_requested()) {
        const auto current = [this, &stop, begun = epoch_.load()] {
            return !stop.stop_requested() && epoch_.load(std::memory_order_relaxed) == begun;
        };
        const KeepGoing keepGoing = std::cref(current); // needs no memory
        if (mesh_) {
            buildScene(lock, keepGoing);
        } else {
            traceNext(lock, keepGoing);
        }
    }
}

void TexelTracer::buildScene(std::unique_lock<std::mutex>& lock, const KeepGoing& keepGoing) {
    building_ = true;
    const Epoch epoch = epoch_;
    TriangleMesh mesh = *std::exchange(mesh_, std::nullopt);
    std::shared_ptr<const RayScene> old = std::move(scene_);
    lock.unlock();
    old.reset();
    std::shared_ptr<const RayScene> built;
    AoStatus status;
    try {
        Result<RayScene> result = RayScene::create(std::move(mesh), keepGoing);
        status = result.status();
        if (result) {
            built = std::make_shared<RayScene>(std::move(*result));
        }
    } catch (const std::bad_alloc&) {
        status = outOfMemory();
    }
    lock.lock();
    if (epoch != epoch_) {
        lock.unlock();
        built.reset();
        lock.lock();
        return;
    }
    building_ = false;
    scene_ = std::move(built);
    if (!scene_) {
        queue_.clear();
    }
    fail(std::move(status));
    work_.notify_all();
    changed_.notify_all();
}

void TexelTracer::traceNext(std::unique_lock<std::mutex>& lock, const KeepGoing& keepGoing) {
    const Epoch epoch = epoch_;
    const TexelRequest request = queue_.front();
    queue_.pop_front();
    ++begun_;
    std::shared_ptr<const RayScene> scene = scene_;
    lock.unlock();
    std::optional<TracedTexels> traced;
    AoStatus status;
    try {
        traced = traceRequest(*scene, request, keepGoing);
    } catch (const std::bad_alloc&) {
        status = outOfMemory();
    }
    scene.reset();
    lock.lock();
    if (epoch != epoch_) {
        return;
    }
    --begun_;
    try {
        if (traced) {
            finished_.push_back(std::move(*traced));
        }
    } catch (const std::bad_alloc&) {
        status = outOfMemory();
    }
    fail(std::move(status));
    changed_.notify_all();
}

} // namespace aolib
