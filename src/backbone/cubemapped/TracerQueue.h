#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <vector>

#include <aolib/AbstractTexelTracer.h>

#include "backbone/cubemapped/RequestMix.h"
#include "scene/Scene.h"

namespace aolib {

/// The host's tracer, shared by those who want rays: what one asks for takes its turns with what
/// the others wait for.
class TracerQueue {
public:
    enum class Asker : std::uint8_t {
        Texels, ///< of cube maps
        Pixels, ///< of the view at rest in slot 0; those of the other slots follow
    };
    /// Slots that pixelsOf() tells apart.
    static constexpr unsigned kSlots = 64;
    static Asker pixelsOf(unsigned slot) { return static_cast<Asker>(1U + slot % kSlots); }

    explicit TracerQueue(AbstractTexelTracer& tracer) : tracer_(tracer) {}

    /// Gives the tracer the scene as it is now.
    void setScene(const Scene& scene);
    /// The number of the latest scene, as results name it.
    std::uint64_t scene() const { return scene_; }
    /// Replaces what this asker has queued. Keys must leave the highest bit free, and those of
    /// pixels the eight highest.
    void request(Asker asker, std::vector<TexelRequest> queue);
    /// Takes back what this asker has queued.
    void drop(Asker asker);
    /// Up to `most` finished requests, those of others left for them.
    std::vector<TracedTexels> take(Asker asker, std::size_t most);
    /// Requests of this asker that may still come.
    std::size_t pending(Asker asker) const;
    bool wait(double milliseconds) { return tracer_.wait(milliseconds); }
    AoStatus status() const { return tracer_.status(); }
    /// A number that no one who asks for pixels has had before.
    std::uint32_t nextGeneration() { return ++generations_; }

private:
    AbstractTexelTracer& tracer_;
    RequestMix waiting_;
    std::map<Asker, std::deque<TracedTexels>> finished_;
    std::uint64_t scene_ = 0;
    std::uint32_t generations_ = 0;
};

} // namespace aolib
