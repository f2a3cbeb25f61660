#pragma once

#include <deque>
#include <string>
#include <vector>

#include "bench/PassTimer.h"

namespace aolib::viewer {

/// What the latest frames took, pass by pass.
class FrameTimes {
public:
    static constexpr std::size_t kKept = 160;

    /// Adds a frame; the oldest goes when there are more than kKept.
    void add(std::vector<bench::PassTime> passes);
    void clear() { frames_.clear(); }

    /// Oldest first.
    const std::deque<std::vector<bench::PassTime>>& frames() const { return frames_; }
    /// Names of all passes since the beginning, in the order of their first appearance: a pass
    /// keeps its place, and so its colour.
    const std::vector<std::string>& passes() const { return passes_; }
    /// Median over the frames that are kept, milliseconds; a frame without the pass counts as 0.
    double median(const std::string& pass) const;
    /// Of all passes of a frame together, milliseconds.
    static double total(const std::vector<bench::PassTime>& frame);
    double longest() const;

private:
    std::deque<std::vector<bench::PassTime>> frames_;
    std::vector<std::string> passes_;
};

} // namespace aolib::viewer
