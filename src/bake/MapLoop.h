#pragma once

#include <functional>
#include <vector>

#include <aolib/bake/AbstractBaker.h>

#include "bake/TexelReceivers.h"

namespace aolib::bake {

/// Gives the values of a map's texels that are not empty. `progress` is never empty.
using BakeOneMap = std::function<Status(TexelReceivers& receivers, int number, BakedMap& map,
                                        const BakeProgress& progress)>;

/// Bakes the maps of a scene one after the other, by whatever method, pads and fills them.
/// Errors: InvalidOption, Cancelled, OutOfMemory, InvalidPosition where no texel is covered, and
/// those of `bake`.
Result<std::vector<BakedMap>> bakeEachMap(const BakeGeometry& geometry, const MapOptions& options,
                                          const BakeProgress& progress, const BakeOneMap& bake);

/// What bakers answer when cancelled, where there is no texel, and no memory.
Status cancelledBake();
Status noTexels();
Status noMemoryForMaps(const MapOptions& options);

} // namespace aolib::bake
