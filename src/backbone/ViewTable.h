#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <vector>

#include "backbone/ViewState.h"

namespace aolib {

/// The views of an instance: which one a frame belongs to, and which are given up. No GL but what
/// the states hold.
///
/// Where a host draws several views by one id, the table distinguishes them by their cameras once
/// they rest: of cameras at several places that take turns each is a view of its own.
class ViewTable {
public:
    /// Views are given up after so many frames of others, and after so many for each view there is.
    static constexpr std::uint64_t kIdleFrames = 256;
    static constexpr std::uint64_t kIdleRounds = 8;
    /// Views that have been drawn within so many frames, and within so many for each view, count
    /// for what is said of all views.
    static constexpr std::uint64_t kRecentFrames = 64;
    static constexpr std::uint64_t kRecentRounds = 2;
    /// Most views at a time: the one that was drawn longest ago makes room.
    static constexpr std::size_t kMost = 64;
    /// Frames by one id in a row that show what was shown of late until they are views of their
    /// own: more than a camera has that walks back the way it came.
    static constexpr int kTurns = 6;
    /// Most of them by one id, and frames that count as of late.
    static constexpr std::size_t kMostPerId = 8;

    using Make = std::function<std::unique_ptr<ViewState>()>;

    explicit ViewTable(Make make) : make_(std::move(make)) {}

    /// The view that a frame belongs to; it is the current one from now on. Gives up idle ones.
    ViewState& begin(ViewId id, const Viewpoint& viewpoint);
    void remove(ViewId id);

    /// The view of the latest frame; null before the first, or when it was removed.
    ViewState* current() const { return current_; }
    /// The one that was drawn last by an id; null where there is none.
    ViewState* find(ViewId id) const;
    const std::vector<std::unique_ptr<ViewState>>& all() const { return states_; }
    bool isRecent(const ViewState& state) const;

    /// Makes another view the current one for as long as it lives.
    class Visit {
    public:
        Visit(ViewTable& table, ViewState& state) : table_(table), before_(table.current_) {
            table.current_ = &state;
        }
        ~Visit() { table_.current_ = before_; }
        Visit(const Visit&) = delete;
        Visit& operator=(const Visit&) = delete;

    private:
        ViewTable& table_;
        ViewState* before_;
    };

private:
    /// The frames of an id.
    struct History {
        std::deque<Viewpoint> viewpoints; ///< of late, the latest last
        int returns = 0;                  ///< frames in a row that showed one of these
    };

    ViewState& choose(ViewId id, const Viewpoint& viewpoint);
    /// Whether a viewpoint is one of several that take turns. @param latest  of the view drawn last
    bool takesTurns(ViewId id, const Viewpoint& viewpoint, const Viewpoint& latest);
    ViewState* idleOf(ViewId id) const;
    ViewState& add(ViewId id);
    void giveUpIdle();
    void dropHistories();

    Make make_;
    std::vector<std::unique_ptr<ViewState>> states_;
    std::map<ViewId, History> histories_; ///< of those that have views
    ViewState* current_ = nullptr;
    std::uint64_t frames_ = 0; ///< begun
};

} // namespace aolib
