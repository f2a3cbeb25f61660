#pragma once

#include <span>
#include <utility>
#include <vector>

#include <glm/vec4.hpp>

#include "bake/gpu/LightView.h"
#include "bake/scatter/MapStack.h"
#include "bake/scatter/PointShape.h"
#include "bake/scatter/PointTarget.h"
#include "bake/scatter/PointWeights.h"

namespace aolib::bake {

/// Stage 2 of scattering on the CPU: adds the pixels of a picture to the texels as splats.
class CpuSplatter {
public:
    /// Shapes and the target's facets must outlive it.
    CpuSplatter(std::span<const PointShape> shapes, PointWeights weights, const MapStack& stack,
                const PointTarget& target)
        : shapes_(shapes), weights_(std::move(weights)), stack_(stack), target_(target) {}

    /// Adds the light from one direction.
    /// @param picture  per pixel: u, v, number of the triangle from 1, or 0 for none.
    /// @param light    per texel of the target: weighed direction, weight.
    void add(const std::vector<glm::vec4>& picture, const LightView& view,
             std::span<glm::vec4> light) const;

private:
    std::span<const PointShape> shapes_;
    PointWeights weights_;
    MapStack stack_;
    PointTarget target_;
};

} // namespace aolib::bake
