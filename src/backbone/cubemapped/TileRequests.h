#pragma once

#include <map>
#include <optional>
#include <vector>

#include "backbone/cubemapped/CubeMapProjector.h"
#include "backbone/cubemapped/Survey.h"

namespace aolib {

/// What a survey's points come to.
struct RequestedTiles {
    float coverage = 1.0F; ///< share that is shaded, or may be once what is on its way has come
    std::optional<glm::vec3> missing; ///< one amidst those that are not, world units
};

/// Asks for the tiles of cube maps in which a survey's points lie; for their blocks, too, where
/// pixels are finer than texels, or where something hides a point from the cube map that might know
/// it: as the scale of the blocks says.
/// @param projectors  those in use
/// @param passes      that a block needs
/// @param asked       by the view, noted here
RequestedTiles requestTiles(const std::vector<CubeMapProjector*>& projectors,
                            const SurveyAnswer& answer, const BlockStore& blocks, int passes,
                            std::map<CubeMapId, AskedTiles>& asked);

} // namespace aolib
