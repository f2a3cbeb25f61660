#pragma once

#include <map>
#include <optional>
#include <vector>

#include "backbone/cubemaps/CubeMapProjector.h"
#include "backbone/passes/FeedbackPass.h"

namespace aolib {

/// What the points of a feedback result come to.
struct RequestedTiles {
    float coverage = 1.0F; ///< share that is shaded, or may be once pending tiles are computed
    std::optional<glm::vec3> missing; ///< one amidst those that are not, world units
};

/// Requests the tiles of cube maps in which the result's points lie; and their pages where
/// pixels are finer than texels, or where something hides a point from the cube map that looks its
/// way it, as the kind of pages says.
/// @param projectors  those in use
/// @param passes      that a page needs
/// @param requested   by the view, to which they are added
RequestedTiles requestTiles(const std::vector<CubeMapProjector*>& projectors,
                            const FeedbackResult& result, const PageStore& pages, int passes,
                            std::map<CubeMapId, TileSet>& requested);

} // namespace aolib
