#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <vector>

#include <aolib/AbstractTexelTracer.h>

namespace aolib {

/// Orders the pending requests of several clients of a tracer: the client with the fewest traced
/// rays is next. No GL.
class RequestMix {
public:
    using Client = unsigned;

    /// Replaces the pending requests of one client.
    void set(Client client, std::vector<TexelRequest> requests);
    /// Removes an answered request of a client; does nothing if no request has this key.
    void answered(Client client, std::uint64_t key);
    /// Removes the pending requests of all clients.
    void clear() { shares_.clear(); }

    std::size_t count(Client client) const;
    /// Returns all pending requests in the order of tracing.
    std::vector<TexelRequest> mixed() const;

private:
    struct Share {
        std::deque<TexelRequest> waiting;
        double had = 0.0; ///< rays, of what was answered
    };
    std::map<Client, Share> shares_; ///< of those who wait
};

} // namespace aolib
