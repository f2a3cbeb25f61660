#include "backbone/passes/TileRequests.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "shared/cube_faces.h"

namespace aolib {

namespace {

/// Texels this many times as wide as the pixels that show them are too coarse for edges.
constexpr float kCoarse = 1.25F;

/// The same for one cube map. @param covered  by point; set for those that it may shade yet.
void requestTilesOf(CubeMapProjector& projector, const FeedbackResult& result,
                    const PageStore& pages, int passes, TileSet& requested,
                    std::vector<bool>& covered) {
    const bool ofHidden = pages.kind() == PageKind::HiddenLayer;
    const bool recent = projector.isSeenBy(result.frame);
    const bool seen = std::ranges::count(result.projected, projector.id()) > 0;
    const glm::vec3 toEye(result.eye - glm::dvec3(projector.position()));
    const TileTable& tiles = projector.tiles();
    const auto size = static_cast<float>(tiles.faceSize());
    for (std::size_t i = 0; i < result.points.size(); ++i) {
        const glm::vec3 p = toEye + result.points[i];
        const int face = shared::faceOf(p);
        const glm::vec3 inFace = shared::toFace(face, p);
        const float perUnit = 0.5F * size / inFace.z; // texels
        if (!std::isfinite(inFace.z * perUnit)) {     // the centre itself, or beyond floats
            continue;
        }
        const glm::vec2 at = glm::vec2(inFace) * perUnit + 0.5F * size;
        const bool hidden = ofHidden && result.hiddenFrom[i] == projector.id();
        const bool page =
            ofHidden ? recent && hidden : 1.0F > kCoarse * result.footprints[i] * perUnit;
        projector.request(face, at, page && pages.fits() ? passes : 0, requested);
        if (!covered[i]) {
            const int tile = tiles.tileAt(face, at);
            covered[i] = !seen || !tiles.isKnownSince(tile, result.frame) ||
                         (hidden && (!recent || tiles.hasPendingPages(tile, passes)));
        }
    }
}

/// The point nearest to the middle of those that are not covered.
std::optional<glm::vec3> missingOf(const FeedbackResult& result, const std::vector<bool>& covered) {
    glm::dvec3 sum(0.0);
    double count = 0.0;
    for (std::size_t i = 0; i < covered.size(); ++i) {
        if (!covered[i]) {
            sum += glm::dvec3(result.points[i]);
            count += 1.0;
        }
    }
    std::optional<glm::vec3> nearest;
    const glm::vec3 middle(sum / std::max(count, 1.0));
    for (std::size_t i = 0; i < covered.size(); ++i) {
        if (!covered[i] && (!nearest || glm::distance(result.points[i], middle) <
                                            glm::distance(*nearest, middle))) {
            nearest = result.points[i];
        }
    }
    return nearest ? std::optional(glm::vec3(result.eye + glm::dvec3(*nearest))) : nearest;
}

} // namespace

RequestedTiles requestTiles(const std::vector<CubeMapProjector*>& projectors,
                            const FeedbackResult& result, const PageStore& pages, int passes,
                            std::map<CubeMapId, TileSet>& requested) {
    std::vector<bool> covered = result.shades;
    for (CubeMapProjector* projector : projectors) {
        requestTilesOf(*projector, result, pages, passes, requested[projector->id()], covered);
    }
    if (covered.empty()) {
        return {};
    }
    return {static_cast<float>(std::ranges::count(covered, true)) /
                static_cast<float>(covered.size()),
            missingOf(result, covered)};
}

} // namespace aolib
