#pragma once

#include <memory>
#include <optional>
#include <utility>

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>

#include "backbone/cubemaps/TileTable.h"
#include "backbone/frame/Frame.h"
#include "backbone/texels/SceneGeometry.h"

namespace aolib {

/// Nearest and farthest distance of geometry from a cube's centre, world units.
struct DistanceRange {
    float nearest;
    float farthest;
};

/// The range of the scene as seen from `centre`, with a little room to both sides.
DistanceRange distanceRange(const Scene& scene, const glm::vec3& centre);

/// World axes to a face's: right, up, forward.
glm::mat3 cubeToFace(int face);

/// Whether a box reaches into the frustum of a face. May say yes to a box just outside.
bool reachesFace(const Bounds& box, const glm::dvec3& centre, int face);

/// What a camera sees of a cube map's surroundings: one more face beside those of the cube, finer
/// than they are.
struct ViewFace {
    /// Rows x, y and w of clip space, of directions in world axes.
    glm::mat3 frustum{1.0F};
    float leastClip = 1.0F; ///< clip w per world unit of distance, at least
    glm::ivec2 size{0};     ///< texels, which are the view's pixels

    /// Only of a perspective camera.
    static ViewFace of(const HostCamera& camera, const glm::ivec2& size,
                       const ClipConvention& clip);
};

/// Draws the scene as it was at the beginning, seen from a point, with the shader that is bound.
/// The near plane lies just within the distance to the nearest triangle: none is clipped, and the
/// depth buffer's precision is spent where geometry is.
class FaceCapture {
public:
    /// @param size  texels along a face's edge
    /// @param view  from the same centre, if there is one
    FaceCapture(const BackboneContext& context,
                std::shared_ptr<const SceneGeometry::Instances> instances, const glm::dvec3& centre,
                int size, const DistanceRange& range, const std::optional<ViewFace>& view = {})
        : context_(context), instances_(std::move(instances)), centre_(centre), size_(size),
          range_(range), view_(view) {}

    /// Draws what lies before a face, or the view's, into the viewport, with depth test.
    /// @return whether there is anything.
    bool draw(gl::GLSLShader& shader, int face) const;

    /// With that of the view.
    int faces() const { return kFaces + (view_ ? 1 : 0); }
    /// Texels along the edge of a face of the cube.
    int size() const { return size_; }
    /// Texels of any face.
    glm::ivec2 size(int face) const { return face < kFaces ? glm::ivec2(size_) : view_->size; }
    const glm::dvec3& centre() const { return centre_; }
    const std::optional<ViewFace>& view() const { return view_; }

private:
    const BackboneContext context_;
    const std::shared_ptr<const SceneGeometry::Instances> instances_;
    const glm::dvec3 centre_;
    const int size_;
    const DistanceRange range_;
    const std::optional<ViewFace> view_;
};

} // namespace aolib
