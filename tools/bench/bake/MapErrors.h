#pragma once

#include <cstdint>
#include <vector>

#include <aolib/bake/AbstractBaker.h>

namespace aolib::bench {

/// Whether a chart's border goes through a texel or one of those about it.
bool atSeam(const bake::BakedMap& map, int x, int y);

/// For `bake::MapOptions::wanted`: all texels at seams, and as many of those inside charts, drawn
/// by chance, always the same ones.
std::vector<std::uint8_t> sampledTexels(const bake::BakedMap& map, int inside);

/// How far a map is from another one. Texels at seams are those a chart's border goes through, and
/// those beside them.
struct MapErrors {
    double inside = 0.0;    ///< RMSE of W away from seams
    double seams = 0.0;     ///< RMSE of W at seams
    double bias = 0.0;      ///< mean of W's difference, away from seams
    double bentAngle = 0.0; ///< mean angle between bent normals where 0.1 < W < 0.9, degrees
    int compared = 0;       ///< texels
};

/// @param truth  texels whose W is below 0 are not compared.
MapErrors errorsOf(const bake::BakedMap& map, const bake::BakedMap& truth);

} // namespace aolib::bench
