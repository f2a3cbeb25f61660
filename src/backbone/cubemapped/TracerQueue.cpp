#include "backbone/cubemapped/TracerQueue.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include <glm/mat4x4.hpp>

namespace aolib {

namespace {

constexpr unsigned kAskerBit = 63;

std::size_t numberOf(TracerQueue::Asker asker) {
    return static_cast<std::size_t>(asker);
}

} // namespace

void TracerQueue::setScene(const Scene& scene) {
    std::vector<glm::vec3> positions;
    std::vector<std::uint32_t> indices;
    for (const auto& [id, mesh] : scene.meshes()) {
        const auto first = static_cast<std::uint32_t>(positions.size());
        const glm::dmat4 transform(mesh.transform);
        for (const glm::vec3& position : mesh.positions) {
            positions.emplace_back(glm::dvec3(transform * glm::dvec4(position, 1.0)));
        }
        for (const std::uint32_t index : mesh.indices) {
            indices.push_back(first + index);
        }
    }
    scene_ = tracer_.setScene(std::move(positions), std::move(indices));
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
