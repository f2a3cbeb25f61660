#include "backbone/cubemapped/TracerQueue.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "scene/WorldTriangles.h"

namespace aolib {

namespace {

constexpr unsigned kAskerBit = 63;

std::size_t numberOf(TracerQueue::Asker asker) {
    return static_cast<std::size_t>(asker);
}

} // namespace

void TracerQueue::setScene(const Scene& scene) {
    TriangleMesh all = worldTriangles(scene);
    tracer_.setScene(std::move(all.positions), std::move(all.indices), std::move(all.normals));
    finished_ = {};
}

void TracerQueue::request(Asker asker, std::vector<TexelRequest> queue) {
    for (TexelRequest& request : queue) {
        request.key |= std::uint64_t{numberOf(asker)} << kAskerBit;
    }
    latest_ = asker;
    tracer_.request(std::move(queue));
}

void TracerQueue::drop(Asker asker) {
    finished_[numberOf(asker)].clear();
    if (latest_ == asker && tracer_.pending() > 0) {
        tracer_.request({});
    }
}

std::vector<TracedTexels> TracerQueue::take(Asker asker, std::size_t most) {
    std::deque<TracedTexels>& mine = finished_[numberOf(asker)];
    if (mine.size() < most) {
        for (TracedTexels& traced : tracer_.take(most)) {
            const std::uint64_t key = traced.request.key;
            traced.request.key = key & ~(std::uint64_t{1} << kAskerBit);
            finished_[key >> kAskerBit].push_back(std::move(traced));
        }
    }
    const auto end = mine.begin() + static_cast<std::ptrdiff_t>(std::min(most, mine.size()));
    std::vector<TracedTexels> taken(std::make_move_iterator(mine.begin()),
                                    std::make_move_iterator(end));
    mine.erase(mine.begin(), end);
    return taken;
}

std::size_t TracerQueue::pending(Asker asker) const {
    return finished_[numberOf(asker)].size() + (latest_ == asker ? tracer_.pending() : 0);
}

} // namespace aolib
