#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

namespace aolib::bake {

/// Sums of one map's texels, row by row.
struct TexelSums {
    glm::ivec2 size{0};
    std::span<const glm::vec4> light; ///< weighed direction, weight
    std::span<const float> coverage;  ///< the share that charts cover
    std::span<const float> facets;    ///< 0 where there is none
};

/// Light and coverage of a texel; where charts cover so little of it that a few points decide, as
/// much of its neighbours of the same facet is added as makes up for it.
/// @return weighed direction, weight; both per covered share. 0 where nothing is covered.
glm::vec4 lightPerCoverage(const TexelSums& sums, std::size_t texel);

} // namespace aolib::bake
