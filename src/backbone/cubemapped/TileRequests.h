#pragma once

#include <vector>

#include "backbone/cubemapped/CubeMapProjector.h"
#include "backbone/cubemapped/Survey.h"

namespace aolib {

/// Asks for the tiles of cube maps in which a survey's points lie; for their blocks, too, where
/// pixels are finer than texels, or where something hides a point from the cube map that might know
/// it: as the scale of the blocks says.
/// @param projectors  those in use
/// @param passes      that a block needs
/// @return the share of the points that are shaded, or may be once what is on its way has come.
float requestTiles(const std::vector<CubeMapProjector*>& projectors, const Survey::Answer& answer,
                   const BlockStore& blocks, int passes);

} // namespace aolib
