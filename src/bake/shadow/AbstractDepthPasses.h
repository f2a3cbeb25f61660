#pragma once

#include <span>

#include <aolib/Status.h>

#include "bake/gpu/LightView.h"
#include "bake/shadow/ReceiverSums.h"

namespace aolib::bake {

/// What the ways to find out by depth maps which receivers are lit have in common.
struct DepthSettings {
    int size = 0;           ///< texels along a depth map
    int mapsPerPass = 0;    ///< made less where no texture holds so many
    float bias = 0.0F;      ///< texels of a depth map, times the slope
    glm::vec4 ground{0.0F}; ///< up and height in the frame; up 0 for none
};

/// The GL side of shadow-map occlusion. Needs known GL state in each call.
class AbstractDepthPasses {
public:
    virtual ~AbstractDepthPasses() = default;

    /// Adds what up to `mapsPerPass` directions light. Errors: OutOfMemory.
    virtual AoStatus addDirections(std::span<const LightView> views, ReceiverSums& sums) = 0;
    /// As in the settings, after all.
    virtual int mapsPerPass() const = 0;
};

} // namespace aolib::bake
