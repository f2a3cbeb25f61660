#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "bench/OpenedScene.h"
#include "bench/Receivers.h"
#include "content/LoadError.h"
#include "parallel/ParallelLoop.h"

namespace aolib::bench {

/// How the truth of a case is traced. Everything here is part of the cache's key.
struct TruthSettings {
    PictureSize size;
    int stride = 3; ///< pixels along a lattice cell, of which one is traced
    int rays = 512; ///< per point
    std::uint64_t seed = 1;
};

/// Ray-traced W at a lattice of pixels.
struct Truth {
    Receivers receivers;
    std::vector<float> visibility;    ///< W per receiver
    std::vector<float> standardError; ///< of each W
    double noise = 0.0;               ///< expected RMSE of W from sampling
    std::vector<float> drawn;         ///< depths of the picture that receivers follow, or none
    bool fromCache = false;
};

/// Traces the truth of a case, step falloff and geometric normals, or reads it from `cache`, where
/// it is kept afterwards; an empty path keeps nothing. Files of the cache that do not fit are
/// traced again.
/// Errors: the cache cannot be written; what the tracer rejects.
Result<Truth, LoadError> traceTruth(const OpenedScene& scene, const BenchCase& which,
                                    const TruthSettings& settings,
                                    const std::filesystem::path& cache,
                                    const LoopProgress& progress = {});

/// Makes a truth that of a picture: of the surfaces that were drawn (see followPicture()).
/// @param depths  of all pixels, 0 to 1. @return how many receivers have moved, or what the tracer
/// rejects.
Result<std::size_t, LoadError> followPicture(const OpenedScene& scene, const BenchCase& which,
                                             const TruthSettings& settings,
                                             std::vector<float> depths, Truth& truth);

/// Everything that the truth of a case depends on, as text: the cache's key.
std::string truthKey(const OpenedScene& scene, const BenchCase& which,
                     const TruthSettings& settings);

} // namespace aolib::bench
