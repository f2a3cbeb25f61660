#pragma once

#include "backbone/cubemapped/CubeMapProjector.h"
#include "backbone/cubemapped/Survey.h"

namespace aolib {

/// Asks for the tiles of a cube map in which a survey's points lie; for their blocks, too, where
/// pixels are finer than texels, or where something hides a point from the cube map that might know
/// it: as the scale of the blocks says.
/// @param passes  that a block needs.
void requestTiles(CubeMapProjector& projector, const Survey::Answer& answer,
                  const BlockStore& blocks, int passes);

} // namespace aolib
