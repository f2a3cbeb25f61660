#include "backbone/cubemapped/TileRequests.h"

#include <cmath>

#include "shared/cube_faces.h"

namespace aolib {

namespace {

/// Texels this many times as wide as the pixels that show them are too coarse for edges.
constexpr float kCoarse = 1.25F;

} // namespace

void requestTiles(CubeMapProjector& projector, const Survey::Answer& answer,
                  const BlockStore& blocks, int passes) {
    const bool ofHidden = blocks.scale() == 1;
    const bool recent = answer.frame > projector.surveysBefore;
    const glm::vec3 toEye(answer.eye - glm::dvec3(projector.position()));
    const auto size = static_cast<float>(projector.tiles.faceSize());
    for (std::size_t i = 0; i < answer.points.size(); ++i) {
        const glm::vec3 p = toEye + answer.points[i];
        const int face = shared::faceOf(p);
        const glm::vec3 inFace = shared::toFace(face, p);
        const float perUnit = 0.5F * size / inFace.z; // texels
        if (!std::isfinite(inFace.z * perUnit)) {     // the centre itself, or beyond floats
            continue;
        }
        const bool block = ofHidden ? recent && answer.hiddenFrom[i] == projector.id()
                                    : 1.0F > kCoarse * answer.footprints[i] * perUnit;
        projector.tiles.ask(face, glm::vec2(inFace) * perUnit + 0.5F * size,
                            block && blocks.fits() ? passes : 0);
    }
}

} // namespace aolib
