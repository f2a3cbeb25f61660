#pragma once

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include <aolib/Options.h>

#include "image/Image.h"
#include "raytracing/RayScene.h"
#include "reference/PictureTracer.h"
#include "viewer/TruthAverage.h"

namespace aolib::viewer {

/// What a truth is of.
struct TruthRequest {
    PictureCamera camera;
    double radius = 1.0; ///< world units, above 0
    Falloff falloff = Falloff::Step;
    NormalSource normals = NormalSource::Geometric;
    int rays = 256; ///< per pixel, when it is done

    /// Whether rays of the one count for the other.
    bool sameView(const TruthRequest& other) const;
};

/// A truth as far as it is known.
struct TracedTruth {
    TruthRequest request;
    FloatImage visibility; ///< background -1
    int rays = 0;          ///< per pixel
    double noise = 0.0;    ///< expected RMSE of W from sampling
};

/// Traces the truth of a view on threads of its own, better and better, until it is asked for
/// another. Threads: all functions from one.
class TruthWorker {
public:
    struct State {
        std::shared_ptr<const TracedTruth> truth; ///< null until there is one of this view
        float progress = 0.0F;                    ///< 0 to 1
        bool working = false;                     ///< it will get better by itself
        std::string failure;                      ///< why there is none
    };

    /// @param wake     called from any thread whenever state() has changed.
    /// @param threads  that trace, 0 for one per core but one.
    explicit TruthWorker(std::function<void()> wake, int threads = 0);
    /// Stops within a fraction of a second.
    ~TruthWorker();
    TruthWorker(const TruthWorker&) = delete;
    TruthWorker& operator=(const TruthWorker&) = delete;

    /// Another scene: what was asked for is forgotten.
    void setScene(TriangleMesh mesh);
    /// Asks for a view's truth. Begins when it was asked for the same one for a moment; goes on
    /// where it was if that is what it is at.
    void follow(const TruthRequest& request);
    /// Nothing is wanted; what is known is forgotten.
    void stop();

    State state() const;

private:
    void loop(const std::stop_token& ending);
    void work(std::unique_lock<std::mutex>& lock, const std::stop_token& ending);
    AoStatus buildScene(std::unique_lock<std::mutex>& lock, const std::stop_token& ending);
    void tracePass(std::unique_lock<std::mutex>& lock, const std::stop_token& ending);
    void change(); ///< after which what is under way is out of date; `mutex_` is held

    const std::function<void()> wake_;
    const int threads_;
    mutable std::mutex mutex_;
    std::condition_variable_any changed_;
    std::uint64_t generation_ = 0;     ///< counts changes
    std::optional<TriangleMesh> mesh_; ///< of a scene not built yet
    std::optional<TruthRequest> request_;
    State state_;

    // Of the worker's thread alone.
    std::optional<RayScene> scene_;
    TruthAverage average_;

    std::jthread thread_; ///< last: it ends before the rest goes
};

} // namespace aolib::viewer
