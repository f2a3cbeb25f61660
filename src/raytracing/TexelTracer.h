#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>
#include <vector>

#include <aolib/AbstractTexelTracer.h>
#include <aolib/Status.h>

#include "raytracing/RayScene.h"

namespace aolib {

/// A queue of requests and the workers that serve it.
///
/// Every `setScene()` begins a new epoch. A worker traces, or builds a scene, without the lock and
/// asks between pieces whether its epoch is still the current one; what it made for an older one is
/// dropped.
class TexelTracer final : public AbstractTexelTracer {
public:
    /// @param threads  at least 1.
    explicit TexelTracer(int threads);
    ~TexelTracer() override;

    void setScene(std::vector<glm::vec3> positions, std::vector<std::uint32_t> indices,
                  std::vector<glm::vec3> normals) override;
    void request(std::vector<TexelRequest> queue) override;
    std::vector<TracedTexels> take(std::size_t most) override;
    bool wait(double milliseconds) override;
    std::size_t pending() const override;
    AoStatus status() const override;

private:
    using Epoch = std::uint64_t;

    void work(const std::stop_token& stop);
    bool somethingToDo() const;
    void buildScene(std::unique_lock<std::mutex>& lock, const KeepGoing& keepGoing);
    void traceNext(std::unique_lock<std::mutex>& lock, const KeepGoing& keepGoing);
    bool idle() const { return queue_.empty() && begun_ == 0; }
    void startWorkers(std::size_t count);
    void fail(AoStatus status);

    const std::size_t threads_;

    mutable std::mutex mutex_;
    std::condition_variable_any work_; ///< there is something to do
    std::condition_variable changed_;  ///< something was finished, or the queue is empty
    std::optional<TriangleMesh> mesh_; ///< waits for a worker to build its scene
    bool building_ = false;            ///< the current epoch's scene
    std::shared_ptr<const RayScene> scene_;
    std::deque<TexelRequest> queue_;
    std::size_t begun_ = 0; ///< requests of the current epoch that workers are at
    std::deque<TracedTexels> finished_;
    AoStatus status_;
    std::atomic<Epoch> epoch_{0};       ///< written under the lock
    std::vector<std::jthread> workers_; ///< last, so that they end first
};

} // namespace aolib
