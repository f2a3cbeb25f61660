#include "viewer/FrameTimes.h"

#include <algorithm>
#include <utility>

namespace aolib::viewer {

void FrameTimes::add(std::vector<bench::PassTime> passes) {
    for (const bench::PassTime& time : passes) {
        if (std::ranges::find(passes_, time.pass) == passes_.end()) {
            passes_.push_back(time.pass);
        }
    }
    frames_.push_back(std::move(passes));
    if (frames_.size() > kKept) {
        frames_.pop_front();
    }
}

double FrameTimes::median(const std::string& pass) const {
    std::vector<double> times;
    for (const std::vector<bench::PassTime>& frame : frames_) {
        double ms = 0.0;
        for (const bench::PassTime& time : frame) {
            ms += time.pass == pass ? time.ms : 0.0;
        }
        times.push_back(ms);
    }
    if (times.empty()) {
        return 0.0;
    }
    const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
    std::ranges::nth_element(times, middle);
    return *middle;
}

double FrameTimes::total(const std::vector<bench::PassTime>& frame) {
    double ms = 0.0;
    for (const bench::PassTime& time : frame) {
        ms += time.ms;
    }
    return ms;
}

double FrameTimes::longest() const {
    double most = 0.0;
    for (const std::vector<bench::PassTime>& frame : frames_) {
        most = std::max(most, total(frame));
    }
    return most;
}

} // namespace aolib::viewer
