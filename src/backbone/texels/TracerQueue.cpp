#include "backbone/texels/TracerQueue.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "scene/WorldTriangles.h"

namespace aolib {

namespace {

using Client = TracerQueue::Client;

/// Set in the keys of pixels, of which the bits below name the view's slot.
constexpr std::uint64_t kPixels = std::uint64_t{1} << 63U;
constexpr unsigned kSlotShift = 56;

unsigned numberOf(Client client) {
    return static_cast<unsigned>(client);
}

/// What a client's keys are marked by.
std::uint64_t markOf(Client client) {
    return client == Client::Texels ? 0
                                    : kPixels | std::uint64_t{numberOf(client) - 1U} << kSlotShift;
}

Client clientOf(std::uint64_t key) {
    return (key & kPixels) == 0
               ? Client::Texels
               : TracerQueue::pixelsOf(static_cast<unsigned>((key & ~kPixels) >> kSlotShift));
}

} // namespace

void TracerQueue::setScene(const Scene& scene) {
    if (!tracer_.status()) {
        waiting_.clear(); // a tracer that failed has dropped all requests
    }
    TriangleMesh all = worldTriangles(scene);
    scene_ =
        tracer_.setScene(std::move(all.positions), std::move(all.indices), std::move(all.normals));
}

void TracerQueue::request(Client client, std::vector<TexelRequest> queue) {
    for (TexelRequest& request : queue) {
        request.key |= markOf(client);
    }
    waiting_.set(numberOf(client), std::move(queue));
    tracer_.request(waiting_.mixed());
}

void TracerQueue::drop(Client client) {
    finished_.erase(client);
    if (waiting_.count(numberOf(client)) > 0) {
        waiting_.set(numberOf(client), {});
        tracer_.request(waiting_.mixed());
    }
}

bool TracerQueue::collect(std::size_t most) {
    std::vector<TracedTexels> collected = tracer_.take(most);
    for (TracedTexels& traced : collected) {
        const std::uint64_t key = traced.request.key;
        const Client by = clientOf(key);
        waiting_.answered(numberOf(by), key);
        traced.request.key = key & ~markOf(by);
        finished_[by].push_back(std::move(traced));
    }
    return !collected.empty();
}

bool TracerQueue::hasResult(Client client) {
    while (finished_[client].empty()) {
        if (!collect(1)) {
            return false;
        }
    }
    return true;
}

std::vector<TracedTexels> TracerQueue::take(Client client, std::size_t most) {
    std::deque<TracedTexels>& mine = finished_[client];
    if (mine.size() < most) {
        collect(most - mine.size());
    }
    const auto end = mine.begin() + static_cast<std::ptrdiff_t>(std::min(most, mine.size()));
    std::vector<TracedTexels> taken(std::make_move_iterator(mine.begin()),
                                    std::make_move_iterator(end));
    mine.erase(mine.begin(), end);
    return taken;
}

std::size_t TracerQueue::pending(Client client) const {
    const auto found = finished_.find(client);
    return (found != finished_.end() ? found->second.size() : 0) + waiting_.count(numberOf(client));
}

} // namespace aolib
