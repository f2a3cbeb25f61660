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

/// The longest time that `wait()` waits, milliseconds: about eleven days.
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

std::uint64_t TexelTracer::setScene(std::vector<glm::vec3> positions,
                                    std::vector<std::uint32_t> indices,
                                    std::vector<glm::vec3> normals) {
    // What it replaces is destroyed after the lock is released.
    std::optional<Numbered<TriangleMesh>> mesh;
    mesh.emplace().content = {std::move(positions), std::move(normals), std::move(indices)};
    const std::scoped_lock lock(mutex_);
    mesh->number = ++given_;
    mesh_.swap(mesh);
    status_ = {};
    startWorkers(1);
    work_.notify_one();
    return given_;
}

void TexelTracer::request(std::vector<TexelRequest> queue) {
    const std::scoped_lock lock(mutex_);
    try {
        queue_.clear();
        if (!mesh_ && !building_ && !scene_.content) {
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

/// Under the lock.
bool TexelTracer::mayBuild() const {
    return mesh_ && !building_ && (!canTrace() || Clock::now() >= nextBuild_);
}

void TexelTracer::work(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    const auto goesOn = [&stop] { return !stop.stop_requested(); };
    const KeepGoing keepGoing = std::cref(goesOn); // needs no memory
    while (work_.wait(lock, stop, [this] { return canTrace() || mayBuild(); }) && goesOn()) {
        if (mayBuild()) {
            buildScene(lock, keepGoing);
        } else {
            traceNext(lock, keepGoing);
        }
    }
}

void TexelTracer::buildScene(std::unique_lock<std::mutex>& lock, const KeepGoing& keepGoing) {
    building_ = true;
    Numbered<TriangleMesh> mesh = *std::exchange(mesh_, std::nullopt);
    lock.unlock();
    const Clock::time_point start = Clock::now();
    std::shared_ptr<const RayScene> built;
    AoStatus status;
    try {
        Result<RayScene> result = RayScene::create(std::move(mesh.content), keepGoing);
        status = result.status();
        if (result) {
            built = std::make_shared<RayScene>(std::move(*result));
        }
    } catch (const std::bad_alloc&) {
        status = outOfMemory();
    }
    const Clock::time_point end = Clock::now();
    lock.lock();
    building_ = false;
    nextBuild_ = end + (end - start);
    if (mesh.number == given_) { // else the scene was replaced meanwhile
        fail(std::move(status));
    }
    if (!built && mesh.number == given_) {
        queue_.clear();
    }
    scene_.number = mesh.number;
    scene_.content.swap(built);
    work_.notify_all();
    changed_.notify_all();
    lock.unlock();
    built.reset(); // the scene before, unless it is still traced
    lock.lock();
}

void TexelTracer::traceNext(std::unique_lock<std::mutex>& lock, const KeepGoing& keepGoing) {
    const TexelRequest request = queue_.front();
    queue_.pop_front();
    ++begun_;
    Numbered<std::shared_ptr<const RayScene>> scene = scene_;
    lock.unlock();
    std::optional<TracedTexels> traced;
    AoStatus status;
    try {
        traced = traceRequest(*scene.content, request, keepGoing);
    } catch (const std::bad_alloc&) {
        status = outOfMemory();
    }
    scene.content.reset();
    lock.lock();
    --begun_;
    try {
        if (traced) {
            traced->scene = scene.number;
            finished_.push_back(std::move(*traced));
        }
    } catch (const std::bad_alloc&) {
        status = outOfMemory();
    }
    fail(std::move(status));
    changed_.notify_all();
}

} // namespace aolib
