#pragma once

#include <string>
#include <vector>

namespace aolib::bench {

/// A line of the grid, and what it is called.
struct Tick {
    double value = 0.0;
    std::string text; ///< empty for none
};

/// Turns values into places along an axis, 0 to 1, with some margin at the ends.
class AxisScale {
public:
    /// @param values  to be shown; those that the scale cannot show are ignored.
    AxisScale(const std::vector<double>& values, bool logarithmic);

    bool shows(double value) const { return !logarithmic_ || value > 0.0; }
    double place(double value) const;
    /// Round values within the range.
    std::vector<Tick> ticks() const;

private:
    double coordinate(double value) const;

    bool logarithmic_;
    double low_ = 0.0;
    double high_ = 1.0;
};

} // namespace aolib::bench
