#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "bench/bake/BakeRun.h"

namespace aolib::bench {

/// How a method's processor time grows with its samples on a mesh: `once + perSample * samples` is
/// the line that fits best, by relative errors.
struct BakeGrowth {
    std::string mesh;
    std::size_t triangles = 0;
    BakeMethodName method = BakeMethodName::Rays;
    int mapSize = 0;        ///< texels
    double once = 0.0;      ///< seconds: what is done but once, whatever the samples
    double perSample = 0.0; ///< seconds
    /// What so many samples take.
    struct Point {
        int samples = 0;
        double whole = 0.0;   ///< seconds
        double growing = 0.0; ///< seconds: the whole without `once`
    };
    std::vector<Point> points; ///< by samples
};

/// Of all mesh, map and method that rows have three or more numbers of samples of: with fewer any
/// line fits.
std::vector<BakeGrowth> growthOf(const std::vector<BakeRow>& rows);

/// A table in Markdown: what is done once, what a sample takes, and how many times as long as the
/// number of samples before it each takes, in the whole and without what is done once.
std::string growthMarkdown(const std::vector<BakeGrowth>& growths);

} // namespace aolib::bench
