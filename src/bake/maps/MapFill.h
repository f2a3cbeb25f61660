#pragma once

#include <cstddef>

#include <glm/vec4.hpp>

#include <aolib/bake/AbstractBaker.h>
#include <aolib/bake/BakeOptions.h>

#include "bake/maps/TexelRaster.h"

namespace aolib::bake {

/// A map without values.
BakedMap emptyMap(const TexelRaster& raster);

/// Turns sums (weighed direction, weight) of a texel into its values; W may yet exceed 1.
/// @param norm  visibility per weight.
void setTexel(BakedMap& map, std::size_t texel, const glm::vec4& sum, double norm,
              const glm::dvec3& normal);

/// Padding and filling as the options say.
void finish(BakedMap& map, const MapOptions& options);

/// Takes the value away from each texel that has one and lies beside one that has none.
void erode(BakedMap& map);

/// Gives texels without a value the mean of those about them that have one, `steps` times.
void dilate(BakedMap& map, int steps);

/// Gives all texels without a value the mean over the smallest square of 2^k texels, at multiples
/// of 2^k, that holds values: what a mipmap's texel mixes in is then its charts' own mean.
void fillRest(BakedMap& map);

} // namespace aolib::bake
