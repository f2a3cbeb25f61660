#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>

#include <aolib/Status.h>
#include <glm/vec3.hpp>

#include "scene/TriangleMesh.h"

namespace aolib {

/// Where a ray first meets the scene. World units.
struct Hit {
    double distance = 0.0;      ///< from the ray's origin
    glm::dvec3 position{0.0};   ///< on the triangle's plane, rebuilt from barycentrics in double
    glm::dvec3 normal{0.0};     ///< geometric, unit length, by the triangle's winding
    std::uint32_t triangle = 0; ///< index into the mesh's triangles
    double u = 0.0;             ///< barycentric weight of the triangle's second vertex
    double v = 0.0;             ///< barycentric weight of the triangle's third vertex
    double clearance = 0.0; ///< a ray starting this far above the triangle does not meet it again
};

/// Triangles that rays can be shot at. Two-sided; triangles without area are left out.
///
/// Rays are traced in single precision, in a frame of the scene's own: centred, and scaled by a
/// power of two into [-1, 1]. So neither a scene's scale nor its distance from the origin costs
/// precision beyond what its float positions have lost already.
///
/// Threads: every const method may be called from many threads at once.
class RayScene {
public:
    /// Builds the acceleration structure. An empty mesh is allowed: nothing is ever hit.
    /// Errors: IncompletePrimitive, InvalidIndex, InvalidPosition, InvalidNormal (not finite, or as
    /// many as there are positions is not what there is), OutOfMemory.
    static Result<RayScene> create(TriangleMesh mesh);

    RayScene(RayScene&&) noexcept;
    RayScene& operator=(RayScene&&) noexcept;
    ~RayScene();

    /// The first hit between `tmin` and `tmax`, or nothing.
    /// @param direction  any length but zero; distances are world units all the same.
    std::optional<Hit> intersect(const glm::dvec3& origin, const glm::dvec3& direction,
                                 double tmin = 0.0,
                                 double tmax = std::numeric_limits<double>::infinity()) const;

    /// Whether anything lies between `tmin` and `tmax`. Cheaper than `intersect()`.
    bool occluded(const glm::dvec3& origin, const glm::dvec3& direction, double tmin = 0.0,
                  double tmax = std::numeric_limits<double>::infinity()) const;

    /// How far to lift a ray's origin off a surface at `position` along the unit `normal`, world
    /// units, when all that is known is that the position was once rounded to float: one float ulp
    /// of the position, and the rounding of the scene's own frame.
    double clearance(const glm::dvec3& position, const glm::dvec3& normal) const;

    /// The mesh as it was given, triangles without area included.
    const TriangleMesh& mesh() const;

private:
    struct Content;
    explicit RayScene(std::unique_ptr<Content> content);

    std::unique_ptr<Content> content_;
};

} // namespace aolib
