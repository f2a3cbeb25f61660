#include "backbone/cubemapped/TracerQueue.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "scene/WorldTriangles.h"

namespace aolib {

namespace {

using Asker = TracerQueue::Asker;

/// Set in the keys of pixels, of which the bits below name the view's slot.
constexpr std::uint64_t kPixels = std::uint64_t{1} << 63U;
constexpr unsigned kSlotShift = 56;

unsigned numberOf(Asker asker) {
    return static_cast<unsigned>(asker);
}

/// What an asker's keys are marked by.
std::uint64_t markOf(Asker asker) {
    return asker == Asker::Texels ? 0 : kPixels | std::uint64_t{numberOf(asker) - 1U} << kSlotShift;
}

Asker askerOf(std::uint64_t key) {
    return (key & kPixels) == 0
               ? Asker::Texels
               : TracerQueue::pixelsOf(static_cast<unsigned>((key & ~kPixels) >> kSlotShift));
}

} // namespace

void TracerQueue::setScene(const Scene& scene) {
    if (!tracer_.status()) {
        waiting_.clear(); // what failed has dropped all that was asked for
    }
    TriangleMesh all = worldTriangles(scene);
    scene_ =
        tracer_.setScene(std::move(all.positions), std::move(all.indices), std::move(all.normals));
}

void TracerQueue::request(Asker asker, std::vector<TexelRequest> queue) {
    for (TexelRequest& request : queue) {
        request.key |= markOf(asker);
    }
    waiting_.set(numberOf(asker), std::move(queue));
    tracer_.request(waiting_.mixed());
}

void TracerQueue::drop(Asker asker) {
    finished_.erase(asker);
    if (waiting_.count(numberOf(asker)) > 0) {
        waiting_.set(numberOf(asker), {});
        tracer_.request(waiting_.mixed());
    }
}

std::vector<TracedTexels> TracerQueue::take(Asker asker, std::size_t most) {
    std::deque<TracedTexels>& mine = finished_[asker];
    if (mine.size() < most) {
        for (TracedTexels& traced : tracer_.take(most)) {
            const std::uint64_t key = traced.request.key;
            const Asker by = askerOf(key);
            waiting_.answered(numberOf(by), key);
            traced.request.key = key & ~markOf(by);
            finished_[by].push_back(std::move(traced));
        }
    }
    const auto end = mine.begin() + static_cast<std::ptrdiff_t>(std::min(most, mine.size()));
    std::vector<TracedTexels> taken(std::make_move_iterator(mine.begin()),
                                    std::make_move_iterator(end));
    mine.erase(mine.begin(), end);
    return taken;
}

std::size_t TracerQueue::pending(Asker asker) const {
    const auto found = finished_.find(asker);
    return (found != finished_.end() ? found->second.size() : 0) + waiting_.count(numberOf(asker));
}

} // namespace aolib
