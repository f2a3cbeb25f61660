#pragma once

#include <span>
#include <vector>

#include "bench/Truth.h"

namespace aolib::bench {

/// How far a method's W lies from the truth, over the lattice's points with a surface in both.
/// Errors are `method - truth`.
struct ErrorFigures {
    double rmse = -1.0; ///< the truth's noise taken off; negative: not known
    double bias = 0.0;
    double percentile95 = -1.0; ///< of |error|, noise included
    double maximum = -1.0;      ///< of |error|, noise included
    double missing = 0.0;       ///< share of the truth's points where the method has no surface
    std::size_t notNumbers = 0; ///< points whose W is NaN or infinite; each counts as an error of 1
};

/// Compares a whole picture of W (row 0 at the bottom, background below 0) with the truth.
ErrorFigures compareWithTruth(std::span<const float> picture, const Truth& truth);
/// Compares one W per point of the truth with it.
ErrorFigures comparePoints(std::span<const float> values, const Truth& truth);

} // namespace aolib::bench
