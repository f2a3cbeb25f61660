#pragma once

#include <cstddef>
#include <vector>

namespace aolib::bench {

/// Repeated measurements in short: the median, and where the middle half of them lies.
struct Spread {
    double median = -1.0; ///< negative: never measured
    double low = -1.0;    ///< lower quartile
    double high = -1.0;   ///< upper quartile
    std::size_t count = 0;
};

/// Quartiles by linear interpolation between the sorted values.
Spread spreadOf(std::vector<double> values);

} // namespace aolib::bench
