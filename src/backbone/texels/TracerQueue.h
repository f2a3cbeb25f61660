#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <vector>

#include <aolib/AbstractTexelTracer.h>

#include "backbone/texels/RequestMix.h"
#include "scene/Scene.h"

namespace aolib {

/// Shares the host's tracer between clients, whose requests are traced by turns.
class TracerQueue {
public:
    enum class Client : std::uint8_t {
        Texels, ///< of cube maps
        Pixels, ///< of the static view in slot 0; those of the other slots follow
    };
    /// Slots that pixelsOf() distinguishes.
    static constexpr unsigned kSlots = 64;
    static Client pixelsOf(unsigned slot) { return static_cast<Client>(1U + slot % kSlots); }

    explicit TracerQueue(AbstractTexelTracer& tracer) : tracer_(tracer) {}

    /// Sends the current scene to the tracer.
    void setScene(const Scene& scene);
    /// The number of the latest scene, as results name it.
    std::uint64_t scene() const { return scene_; }
    /// Replaces what this client has queued. Keys must leave the highest bit free, and those of
    /// pixels the eight highest.
    void request(Client client, std::vector<TexelRequest> queue);
    /// Cancels the queued requests of this client.
    void drop(Client client);
    /// Whether a finished request of this client is there to be taken.
    bool hasResult(Client client);
    /// Takes up to `most` finished requests; those of others are left for them.
    std::vector<TracedTexels> take(Client client, std::size_t most);
    /// Requests of this client that may still come.
    std::size_t pending(Client client) const;
    bool wait(double milliseconds) { return tracer_.wait(milliseconds); }
    AoStatus status() const { return tracer_.status(); }
    /// A number that no client has had before.
    std::uint32_t nextGeneration() { return ++generations_; }

private:
    /// Takes up to `most` finished requests from the tracer, for whichever client. @return whether
    /// there was one.
    bool collect(std::size_t most);

    AbstractTexelTracer& tracer_;
    RequestMix waiting_;
    std::map<Client, std::deque<TracedTexels>> finished_;
    std::uint64_t scene_ = 0;
    std::uint32_t generations_ = 0;
};

} // namespace aolib
