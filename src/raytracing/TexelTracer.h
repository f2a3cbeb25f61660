#pragma once

#include <chrono>
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

/// A scene, and the number that it was given. Not a member of TexelTracer: Clang 14 takes a
/// nested class whose members have initializers as not constructible within the class around it.
template <typename T>
struct Numbered {
    std::uint64_t number = 0;
    T content{};
};

/// A queue of requests and the workers that serve it, without the lock while they trace or build a
/// scene. Neither keeps the other waiting for ever: the next scene is built once requests have been
/// traced for as long as the last one took to build, or when there is nothing to trace.
class TexelTracer final : public AbstractTexelTracer {
public:
    /// @param threads  at least 1.
    explicit TexelTracer(int threads);
    ~TexelTracer() override;

    std::uint64_t setScene(std::vector<glm::vec3> positions, std::vector<std::uint32_t> indices,
                           std::vector<glm::vec3> normals) override;
    void request(std::vector<TexelRequest> queue) override;
    std::vector<TracedTexels> take(std::size_t most) override;
    bool wait(double milliseconds) override;
    std::size_t pending() const override;
    AoStatus status() const override;

private:
    using Clock = std::chrono::steady_clock;

    void work(const std::stop_token& stop);
    bool canTrace() const { return scene_.content && !queue_.empty(); }
    bool mayBuild() const;
    void buildScene(std::unique_lock<std::mutex>& lock, const KeepGoing& keepGoing);
    void traceNext(std::unique_lock<std::mutex>& lock, const KeepGoing& keepGoing);
    bool idle() const { return queue_.empty() && begun_ == 0; }
    void startWorkers(std::size_t count);
    void fail(AoStatus status);

    const std::size_t threads_;

    mutable std::mutex mutex_;
    std::condition_variable_any work_;           ///< there is something to do
    std::condition_variable changed_;            ///< something was finished, or the queue is empty
    std::optional<Numbered<TriangleMesh>> mesh_; ///< waits for a worker to build its scene
    std::uint64_t given_ = 0;                    ///< scenes so far
    bool building_ = false;
    Numbered<std::shared_ptr<const RayScene>> scene_; ///< the latest that was built
    Clock::time_point nextBuild_{}; ///< while there is something to trace, none is built before
    std::deque<TexelRequest> queue_;
    std::size_t begun_ = 0; ///< requests that workers are at
    std::deque<TracedTexels> finished_;
    AoStatus status_;
    std::vector<std::jthread> workers_; ///< last, so that they end first
};

} // namespace aolib
