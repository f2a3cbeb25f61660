#pragma once

#include <vector>

#include "StabilityTest.h"

namespace aolib {

/// How far two lists of W are apart, where both have one.
struct Change {
    double p99 = 0.0; ///< 99th percentile of the absolute differences
    double max = 0.0;
    double above = 0.0;   ///< share of differences above 1/255
    double missing = 0.0; ///< share of places where only one of the two has a W
};
Change changeOf(const std::vector<float>& before, const std::vector<float>& after);

/// The value below which this share of them lies. They are reordered; 0 for none.
double percentile(std::vector<double>& values, double share);

/// How far a picture is from ray tracing, without the truth's own noise.
struct Error {
    double rmse = 0.0;
    double mean = 0.0;        ///< ours minus truth
    double mismatched = 0.0;  ///< share of pixels that are background for only one of the two
    std::vector<float> truth; ///< W per pixel; background -1
};
Error errorOf(const Shot& shot, const Model& model, const Options& options, int rays = 64);

} // namespace aolib
