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

/// Draws the scene as the faces of a cube map see it, with the shader that is bound. The near plane
/// lies just within the distance to the nearest triangle: none is clipped, and the depth buffer's
/// precision goes where geometry is.
class FaceCapture {
public:
    FaceCapture(const BackboneContext& context, const SceneGeometry& geometry,
                const CubeMapProjector& projector, const DistanceRange& range)
        : context_(context), geometry_(geometry), projector_(projector), range_(range) {}

    /// Draws every face that something lies before, each into its part of the bound target, with
    /// depth test. @return which faces those are.
    std::array<bool, kFaces> draw(gl::GLSLShader& shader) const;

private:
    bool drawFace(gl::GLSLShader& shader, int face) const;

    const BackboneContext& context_;
    const SceneGeometry& geometry_;
    const CubeMapProjector& projector_;
    DistanceRange range_;
};

} // namespace aolib
