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

ViewState& ViewTable::begin(ViewId id, const Viewpoint& viewpoint) {
    ++frames_;
    ViewState& state = choose(id, viewpoint);
    state.viewpoint = viewpoint;
    std::deque<Viewpoint>& viewpoints = histories_[id].viewpoints;
    viewpoints.push_back(viewpoint);
    if (viewpoints.size() > kMostPerId) {
        viewpoints.pop_front();
    }
    state.drawn = frames_;
    current_ = &state;
    giveUpIdle();
    return state;
}

ViewState& ViewTable::choose(ViewId id, const Viewpoint& viewpoint) {
    const auto same = std::ranges::find_if(
        states_, [&](const auto& one) { return one->id == id && one->viewpoint == viewpoint; });
    if (same != states_.end()) {
        return **same;
    }
    ViewState* latest = find(id);
    if (latest == nullptr) {
        return add(id);
    }
    if (!takesTurns(id, viewpoint, *latest->viewpoint)) {
        return *latest; // its camera has moved
    }
    if (ViewState* idle = idleOf(id)) {
        return *idle;
    }
    const auto ofId =
        std::ranges::count_if(states_, [&](const auto& one) { return one->id == id; });
    return static_cast<std::size_t>(ofId) < kMostPerId ? add(id) : *latest;
}

bool ViewTable::takesTurns(ViewId id, const Viewpoint& viewpoint, const Viewpoint& latest) {
    // A camera that only jitters within its pixels is one view.
    const bool elsewhere = viewpoint.camera.eye() != latest.camera.eye() ||
                           viewpoint.camera.eyeToWorld() != latest.camera.eyeToWorld() ||
                           viewpoint.size != latest.size;
    History& history = histories_[id];
    const auto before = std::ranges::find(history.viewpoints, viewpoint);
    history.returns = elsewhere && before != history.viewpoints.end() ? history.returns + 1 : 0;
    return history.returns >= kTurns;
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
        dropHistories();
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
    dropHistories();
}

void ViewTable::giveUpIdle() {
    const std::uint64_t limit = frames(kIdleFrames, kIdleRounds, states_.size());
    if (std::erase_if(states_, [&](const auto& one) { return frames_ - one->drawn > limit; }) > 0) {
        dropHistories();
    }
}

void ViewTable::dropHistories() {
    std::erase_if(histories_, [&](const auto& one) { return find(one.first) == nullptr; });
}

bool ViewTable::isRecent(const ViewState& state) const {
    return frames_ - state.drawn <= frames(kRecentFrames, kRecentRounds, states_.size());
}

} // namespace aolib
