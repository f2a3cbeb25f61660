#pragma once

#include <cstddef>
#include <string>

#include <aolib/BakeExport.h>
#include <aolib/bake/BakeScene.h>

namespace aolib::bake {

/// Counts of the usable and unusable UVs of one map. Since 0.1.
struct UvReport {
    std::size_t triangles = 0;         ///< of the surfaces that go to the map
    std::size_t missing = 0;           ///< without UVs
    std::size_t notFinite = 0;         ///< with a UV that is NaN or infinite
    std::size_t outside = 0;           ///< with a UV outside [0,1], as tiling has: no map holds it
    std::size_t collapsed = 0;         ///< with an area in space but none in the map
    std::size_t coveredTexels = 0;     ///< texels whose centre lies in a triangle
    std::size_t overlappingTexels = 0; ///< texels whose centre lies in two or more triangles

    /// Returns the number of triangles that get no texels.
    std::size_t unusable() const { return missing + notFinite + outside + collapsed; }
    /// Returns the share of covered texels that several triangles share, 0 to 1.
    double overlap() const {
        return coveredTexels == 0 ? 0.0 : double(overlappingTexels) / double(coveredTexels);
    }
    /// Returns whether the UVs suffice for a map: at most one triangle in a thousand is unusable,
    /// and at most one texel in a thousand is shared.
    AOLIB_BAKE_EXPORT bool good() const;
    /// Returns the numbers as a sentence: "of 120 triangles 12 have no UVs; 7.5% of the texels are
    /// shared".
    AOLIB_BAKE_EXPORT std::string sentence() const;
};

/// Checks the UVs of the surfaces of map number `map`, on a grid of texels. The scene's indices
/// must be in range. Since 0.1.
AOLIB_BAKE_EXPORT UvReport checkUvs(const BakeScene& scene, int map, int width, int height);

} // namespace aolib::bake
