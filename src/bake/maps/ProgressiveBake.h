#pragma once

#include <functional>
#include <vector>

#include <glm/vec4.hpp>

#include <aolib/bake/AbstractBaker.h>

#include "bake/maps/TexelReceivers.h"

namespace aolib::bake {

/// A map that is being summed: where its texels are looked at from, and what was found there.
struct MapSums {
    TexelReceivers receivers;
    std::vector<glm::vec4> light; ///< per texel: weighed direction, weight
    int samples = 0;              ///< that each texel has got

    MapSums(const BakeGeometry& geometry, const Facets& facets, int map, const MapOptions& options)
        : receivers(geometry, facets, map, options), light(receivers.raster().size()) {}
};

/// A method by which each texel of a map is looked at from by itself.
struct TexelMethod {
    int samples = 0; ///< of each texel
    int least = 1;   ///< that a place in it gets at least
    /// Visibility per weight that so many samples have summed up.
    std::function<double(int samples)> norm;
    /// Adds what some samples of each texel find, from the place where the receivers are now.
    /// `progress` is never empty. Errors: Cancelled, and the method's own.
    std::function<AoStatus(const SampleRange& samples, int map, MapSums& sums,
                           const BakeProgress& progress)>
        add;
};

/// Bakes the maps of a scene in passes over all of them, pads and fills them. Errors:
/// InvalidOption, Cancelled, OutOfMemory, InvalidPosition where no texel is covered, and those of
/// the method.
Result<std::vector<BakedMap>> bakeInPasses(const BakeGeometry& geometry, const MapOptions& options,
                                           const TexelMethod& method, const BakeProgress& progress,
                                           const SnapshotCallback& onSnapshot);

/// What bakers answer when cancelled, where there is no texel, and no memory.
AoStatus cancelledBake();
AoStatus noTexels();
AoStatus noMemoryForMaps(const MapOptions& options);
AoStatus noMemoryForView();

} // namespace aolib::bake
