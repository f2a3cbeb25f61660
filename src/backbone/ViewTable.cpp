#include "backbone/ViewTable.h"

#include <algorithm>

namespace aolib {

namespace {

std::uint64_t frames(std::uint64_t least, std::uint64_t rounds, std::size_t views) {
    return std::max(least, rounds * static_cast<std::uint64_t>(views));
}

bool drawnBefore(const std::unique_ptr<ViewState>& a, const std::unique_ptr<ViewState>& b) {
    return a->drawn < b->drawn;
}

} // namespace

ViewState& ViewTable::begin(ViewId id, const Sight& sight) {
    ++frames_;
    ViewState& state = choose(id, sight);
    if (state.sight != sight) {
        state.returns = state.sightBefore == sight ? state.returns + 1 : 0;
        state.sightBefore = state.sight;
        state.sight = sight;
    }
    state.drawn = frames_;
    current_ = &state;
    giveUpIdle();
    return state;
}

ViewState& ViewTable::choose(ViewId id, const Sight& sight) {
    const auto same = std::ranges::find_if(
        states_, [&](const auto& one) { return one->id == id && one->sight == sight; });
    if (same != states_.end()) {
        return **same;
    }
    ViewState* latest = find(id);
    if (latest == nullptr) {
        return add(id);
    }
    if (latest->sightBefore != sight || latest->returns + 1 < kTurns) {
        return *latest; // its camera has moved
    }
    latest->returns = 0;
    if (ViewState* idle = idleOf(id)) {
        return *idle;
    }
    const auto ofId =
        std::ranges::count_if(states_, [&](const auto& one) { return one->id == id; });
    return static_cast<std::size_t>(ofId) < kMostPerId ? add(id) : *latest;
}

ViewState* ViewTable::find(ViewId id) const {
    ViewState* latest = nullptr;
    for (const auto& state : states_) {
        if (state->id == id && (latest == nullptr || state->drawn > latest->drawn)) {
            latest = state.get();
        }
    }
    return latest;
}

ViewState* ViewTable::idleOf(ViewId id) const {
    const std::uint64_t limit = frames(kMostPerId, kRecentRounds, states_.size());
    const auto found = std::ranges::find_if(
        states_, [&](const auto& one) { return one->id == id && frames_ - one->drawn > limit; });
    return found != states_.end() ? found->get() : nullptr;
}

ViewState& ViewTable::add(ViewId id) {
    if (states_.size() >= kMost) {
        states_.erase(std::ranges::min_element(states_, drawnBefore));
    }
    states_.push_back(make_());
    states_.back()->id = id;
    return *states_.back();
}

void ViewTable::remove(ViewId id) {
    if (current_ != nullptr && current_->id == id) {
        current_ = nullptr;
    }
    std::erase_if(states_, [&](const auto& one) { return one->id == id; });
}

void ViewTable::giveUpIdle() {
    const std::uint64_t limit = frames(kIdleFrames, kIdleRounds, states_.size());
    std::erase_if(states_, [&](const auto& one) { return frames_ - one->drawn > limit; });
}

bool ViewTable::isRecent(const ViewState& state) const {
    return frames_ - state.drawn <= frames(kRecentFrames, kRecentRounds, states_.size());
}

} // namespace aolib
