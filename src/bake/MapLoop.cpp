#include "bake/MapLoop.h"

#include <new>
#include <string>

#include "bake/CheckOptions.h"
#include "bake/MapFill.h"

namespace aolib::bake {

Status cancelledBake() {
    return {StatusCode::Cancelled, "the bake was cancelled"};
}

Status noTexels() {
    return {StatusCode::InvalidPosition, "no triangle has UVs that cover a texel"};
}

Status noMemoryForMaps(const MapOptions& options) {
    return {StatusCode::OutOfMemory, "no memory left for maps of " + std::to_string(options.width) +
                                         " x " + std::to_string(options.height) + " texels"};
}

Result<std::vector<BakedMap>> bakeEachMap(const BakeGeometry& geometry, const MapOptions& options,
                                          const BakeProgress& progress,
                                          const BakeOneMap& bake) try {
    if (Status status = check(options); !status) {
        return status;
    }
    const Facets facets(geometry.scene());
    const int count = geometry.scene().mapCount();
    std::vector<BakedMap> maps;
    bool covered = false;
    for (int number = 0; number < count; ++number) {
        TexelReceivers receivers(geometry, facets, number, options);
        covered = covered || receivers.raster().coveredTexels() > 0;
        const auto share = [&](double fraction) {
            return !progress || progress((number + fraction) / count);
        };
        BakedMap& map = maps.emplace_back(emptyMap(receivers.raster()));
        if (Status status = bake(receivers, number, map, share); !status) {
            return status;
        }
        finish(map, options);
    }
    if (!covered) {
        return noTexels();
    }
    if (progress) {
        progress(1.0);
    }
    return maps;
} catch (const std::bad_alloc&) {
    return noMemoryForMaps(options);
}

} // namespace aolib::bake
