#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <vector>

#include <aolib/AbstractTexelTracer.h>

namespace aolib {

/// What several clients have requested of a tracer and not yet got, in an order that serves all of
/// them alike: whoever has had the fewest rays is next. No GL.
class RequestMix {
public:
    using Client = unsigned;

    /// Replaces what one client waits for.
    void set(Client client, std::vector<TexelRequest> requests);
    /// One of a client's requests was answered; nothing happens where it waits for none of this
    /// key.
    void answered(Client client, std::uint64_t key);
    /// Nobody waits for anything.
    void clear() { shares_.clear(); }

    std::size_t count(Client client) const;
    /// All that is waited for, in the order in which it is to be traced.
    std::vector<TexelRequest> mixed() const;

private:
    struct Share {
        std::deque<TexelRequest> waiting;
        double had = 0.0; ///< rays, of what was answered
    };
    std::map<Client, Share> shares_; ///< of those who wait
};

} // namespace aolib
