#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <vector>

#include <aolib/AbstractTexelTracer.h>

#include "scene/Scene.h"

namespace aolib {

/// The host's tracer, shared by those who want rays. Whoever asks last has the queue; what it held
/// of others is lost, and they ask again.
class TracerQueue {
public:
    enum class Asker : std::uint8_t {
        Texels, ///< of cube maps
        Pixels, ///< of a view at rest
    };

    explicit TracerQueue(AbstractTexelTracer& tracer) : tracer_(tracer) {}

    /// Gives the tracer the scene as it is now.
    void setScene(const Scene& scene);
    /// The number of the latest scene, as results name it.
    std::uint64_t scene() const { return scene_; }
    /// Replaces the queue. A request's key must leave the highest bit free.
    void request(Asker asker, std::vector<TexelRequest> queue);
    /// Takes back what this asker has queued.
    void drop(Asker asker);
    /// Up to `most` finished requests, those of others left for them.
    std::vector<TracedTexels> take(Asker asker, std::size_t most);
    /// Requests of this asker that may still come.
    std::size_t pending(Asker asker) const;
    bool wait(double milliseconds) { return tracer_.wait(milliseconds); }
    AoStatus status() const { return tracer_.status(); }

private:
    AbstractTexelTracer& tracer_;
    std::uint64_t scene_ = 0;
    Asker latest_ = Asker::Texels;
    std::array<std::deque<TracedTexels>, 2> finished_; ///< by asker
};

} // namespace aolib
