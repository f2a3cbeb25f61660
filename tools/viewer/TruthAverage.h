#pragma once

#include <cstddef>
#include <vector>

#include "image/Image.h"
#include "reference/PictureTracer.h"

namespace aolib::viewer {

/// The mean of pictures that were traced one after the other, each with other random numbers.
class TruthAverage {
public:
    void clear();
    /// @param rays  per pixel of this picture: its weight.
    void add(const Picture& picture, int rays);

    int rays() const { return rays_; }
    /// W, background -1. Needs a picture.
    FloatImage visibility() const;
    /// Expected RMSE of that W from sampling.
    double noise() const;

private:
    int width_ = 0;
    int height_ = 0;
    int rays_ = 0;
    std::vector<double> sums_;      ///< of W times rays; background below 0
    std::vector<double> variances_; ///< of those sums
};

/// How many rays the next picture of a progressive trace gets: few at first, then as many as keep
/// each picture short. At least 2.
int raysOfNextPass(int traced, int wanted);

} // namespace aolib::viewer
