#include "bench/plot/AxisScale.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace aolib::bench {

namespace {

constexpr double kMargin = 0.06;    ///< of the range, at each end
constexpr double kLeastSpan = 0.5;  ///< decades
constexpr double kWideSpan = 2.6;   ///< decades from which only powers of ten are named
constexpr double kNarrowSpan = 0.9; ///< decades up to which every digit is named
constexpr int kLinearTicks = 6;

std::string named(double value) {
    char text[40];
    std::snprintf(text, sizeof(text), "%.6g", value);
    return text;
}

} // namespace

AxisScale::AxisScale(const std::vector<double>& values, bool logarithmic)
    : logarithmic_(logarithmic) {
    bool any = false;
    for (const double value : values) {
        if (!shows(value) || !std::isfinite(value)) {
            continue;
        }
        const double at = coordinate(value);
        low_ = any ? std::min(low_, at) : at;
        high_ = any ? std::max(high_, at) : at;
        any = true;
    }
    if (!any) {
        low_ = 0.0;
        high_ = 1.0;
    }
    if (!logarithmic_) {
        low_ = std::min(low_, 0.0);
        high_ = high_ > low_ ? high_ + kMargin * (high_ - low_) : low_ + 1.0;
        return;
    }
    const double lacking = std::max(0.0, kLeastSpan - (high_ - low_));
    const double margin = 0.5 * lacking + kMargin * (high_ - low_ + lacking);
    low_ -= margin;
    high_ += margin;
}

double AxisScale::coordinate(double value) const {
    return logarithmic_ ? std::log10(value) : value;
}

double AxisScale::place(double value) const {
    return (coordinate(value) - low_) / (high_ - low_);
}

std::vector<Tick> AxisScale::ticks() const {
    std::vector<Tick> ticks;
    if (!logarithmic_) {
        const double rough = (high_ - low_) / kLinearTicks;
        const double power = std::pow(10.0, std::floor(std::log10(rough)));
        const double step = power * (rough > 5.0 * power ? 10.0 : rough > 2.0 * power ? 5.0 : 2.0);
        for (double value = 0.0; value <= high_; value += step) {
            ticks.push_back({value, named(value)});
        }
        return ticks;
    }
    const bool wide = high_ - low_ > kWideSpan;
    const bool narrow = high_ - low_ < kNarrowSpan;
    for (int decade = static_cast<int>(std::floor(low_)); decade <= high_; ++decade) {
        for (int digit = 1; digit <= 9; ++digit) {
            const double value = digit * std::pow(10.0, decade);
            const double at = coordinate(value);
            if (at < low_ || at > high_) {
                continue;
            }
            const bool name = narrow || digit == 1 || (!wide && (digit == 2 || digit == 5));
            ticks.push_back({value, name ? named(value) : ""});
        }
    }
    return ticks;
}

} // namespace aolib::bench
