#include "bench/TimeLeft.h"

#include <cmath>

namespace aolib::bench {

TimeLeft::TimeLeft(std::size_t cases, std::size_t methods) : methods_(methods) {
    for (PerMethod& method : methods_) {
        method.left = cases;
    }
}

void TimeLeft::done(std::size_t method, double seconds) {
    PerMethod& row = methods_[method];
    ++row.cells;
    row.left -= row.left > 0 ? 1 : 0;
    row.seconds += seconds;
    total_ += seconds;
}

void TimeLeft::skipCase() {
    for (PerMethod& method : methods_) {
        method.left -= method.left > 0 ? 1 : 0;
    }
}

double TimeLeft::secondsLeft() const {
    std::size_t cells = 0;
    for (const PerMethod& method : methods_) {
        cells += method.cells;
    }
    const double usual = cells > 0 ? total_ / static_cast<double>(cells) : 0.0;
    double left = 0.0;
    for (const PerMethod& method : methods_) {
        const double each =
            method.cells > 0 ? method.seconds / static_cast<double>(method.cells) : usual;
        left += each * static_cast<double>(method.left);
    }
    return left;
}

double TimeLeft::fraction() const {
    const double expected = total_ + secondsLeft();
    return expected > 0.0 ? total_ / expected : 0.0;
}

std::string TimeLeft::text() const {
    if (total_ <= 0.0) {
        return "";
    }
    constexpr double minute = 60.0;
    constexpr double hour = 60.0 * minute;
    const double left = secondsLeft();
    if (left >= hour) {
        const long minutes = std::lround(left / minute);
        return "about " + std::to_string(minutes / 60) + " h " + std::to_string(minutes % 60) +
               " min left";
    }
    return left >= 2.0 * minute
               ? "about " + std::to_string(std::lround(left / minute)) + " min left"
               : "about " + std::to_string(std::lround(left)) + " s left";
}

} // namespace aolib::bench
