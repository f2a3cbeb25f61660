#pragma once

#include <cstdint>
#include <vector>

#include "content/GltfDocument.h"
#include "content/LoadError.h"

namespace aolib {

/// One moving property of a node over time.
struct GltfTrack {
    enum class Path : std::uint8_t { Translation, Rotation, Scale, Weights };
    enum class Interpolation : std::uint8_t { Linear, Step, CubicSpline };

    int node = -1;
    Path path = Path::Translation;
    Interpolation interpolation = Interpolation::Linear;
    std::vector<float> times; ///< seconds, growing, at least one
    std::vector<float>
        values; ///< `components` a key; for CubicSpline in-tangent, value, out-tangent
    std::size_t components = 0; ///< 3, 4 for rotations (x, y, z, w), or the number of weights

    /// The property at a time; before the first key and after the last one it stands still.
    /// Rotations are of unit length.
    std::vector<double> at(double seconds) const;
};

using GltfAnimation = std::vector<GltfTrack>;

/// The animations of a document that was parsed with its motion. Tracks of properties that are not
/// glTF's are left out. Fails on accessors that do not fit, missing nodes, times that do not grow,
/// and values that are not finite.
Result<std::vector<GltfAnimation>, LoadError> readAnimations(const GltfDocument& document);

} // namespace aolib
