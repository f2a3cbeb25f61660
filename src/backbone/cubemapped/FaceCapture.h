#pragma once

#include "backbone/SceneGeometry.h"
#include "backbone/cubemapped/CubeMapProjector.h"

namespace aolib {

/// Nearest and farthest distance of geometry from a cube's centre, world units.
struct DistanceRange {
    float nearest;
    float farthest;
};

/// The range of the scene as seen from `centre`, with a little room to both sides.
DistanceRange distanceRange(const Scene& scene, const glm::vec3& centre);

/// Whether a box reaches into the frustum of a face. May say yes to a box just outside.
bool reachesFace(const Bounds& box, const glm::vec3& centre, int face);

/// Draws the scene as the faces of a cube map see it, with the shader that is bound. The near plane
/// lies just within the distance to the nearest triangle: none is clipped, and the depth buffer's
/// precision goes where geometry is.
class FaceCapture {
public:
    FaceCapture(const BackboneContext& context, const SceneGeometry& geometry,
                const CubeMapProjector& projector, const DistanceRange& range)
        : context_(context), geometry_(geometry), projector_(projector), range_(range) {}

    /// Draws what lies before a face into the viewport, with depth test.
    /// @return whether there is anything.
    bool draw(gl::GLSLShader& shader, int face) const;

    int size() const { return projector_.tiles.faceSize(); }
    const glm::vec3& centre() const { return projector_.position(); }

private:
    const BackboneContext& context_;
    const SceneGeometry& geometry_;
    const CubeMapProjector& projector_;
    DistanceRange range_;
};

} // namespace aolib
