#include "backbone/texels/RequestMix.h"

#include <algorithm>
#include <iterator>
#include <limits>

namespace aolib {

namespace {

double raysOf(const TexelRequest& request) {
    return static_cast<double>(request.width) * request.height * request.rays;
}

} // namespace

void RequestMix::set(Client client, std::vector<TexelRequest> requests) {
    if (requests.empty()) {
        shares_.erase(client);
        return;
    }
    double least = std::numeric_limits<double>::infinity();
    for (const auto& [other, share] : shares_) {
        least = std::min(least, share.had);
    }
    const auto [found, isNew] = shares_.try_emplace(client);
    if (isNew && least < std::numeric_limits<double>::infinity()) {
        found->second.had = least; // a newcomer does not keep the others waiting
    }
    found->second.waiting.assign(std::make_move_iterator(requests.begin()),
                                 std::make_move_iterator(requests.end()));
}

void RequestMix::answered(Client client, std::uint64_t key) {
    const auto found = shares_.find(client);
    if (found == shares_.end()) {
        return;
    }
    std::deque<TexelRequest>& waiting = found->second.waiting;
    const auto request =
        std::ranges::find_if(waiting, [&](const auto& one) { return one.key == key; });
    if (request != waiting.end()) {
        found->second.had += raysOf(*request);
        waiting.erase(request);
    }
}

std::size_t RequestMix::count(Client client) const {
    const auto found = shares_.find(client);
    return found != shares_.end() ? found->second.waiting.size() : 0;
}

std::vector<TexelRequest> RequestMix::mixed() const {
    struct Turn {
        const std::deque<TexelRequest>* waiting;
        std::size_t next;
        double had;
    };
    std::vector<Turn> turns;
    std::size_t count = 0;
    for (const auto& [client, share] : shares_) {
        turns.push_back({&share.waiting, 0, share.had});
        count += share.waiting.size();
    }
    std::vector<TexelRequest> order;
    order.reserve(count);
    while (order.size() < count) {
        Turn* turn = nullptr;
        for (Turn& one : turns) {
            if (one.next < one.waiting->size() && (turn == nullptr || one.had < turn->had)) {
                turn = &one;
            }
        }
        order.push_back((*turn->waiting)[turn->next++]);
        turn->had += raysOf(order.back());
    }
    return order;
}

} // namespace aolib
