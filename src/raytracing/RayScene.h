#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>

#include <aolib/Status.h>
#include <glm/vec3.hpp>

#include "scene/TriangleMesh.h"

/// Embree's scene, so that this header needs none of Embree's.
struct RTCSceneTy;

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

/// A ray as it is traced: single precision, in the scene's frame, its origin moved up to the scene
/// when it lies far away.
struct FrameRay {
    glm::vec3 origin{0.0F};
    glm::vec3 direction{0.0F}; ///< unit length
    float length = 0.0F;       ///< frame units, may be infinite
    bool empty = false;        ///< nothing is left of it between tmin and tmax
};

/// A hit as Embree returns it.
struct FrameHit {
    std::uint32_t primitive = 0; ///< Embree's
    float u = 0.0F;              ///< barycentric weight of the triangle's second vertex
    float v = 0.0F;              ///< barycentric weight of the triangle's third vertex
};

/// Asked now and then, from any thread, whether to go on with what takes long.
using KeepGoing = std::function<bool()>;

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
    /// many as there are positions is not what there is), MissingCapability (Embree does not run on
    /// this processor), OutOfMemory; any where `keepGoing` said no.
    static Result<RayScene> create(TriangleMesh mesh, const KeepGoing& keepGoing = {});

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

    /// How far a ray from an exact `position` may miss along the unit `normal`, world units: the
    /// rounding of the scene's own frame.
    double resolution(const glm::dvec3& position, const glm::dvec3& normal) const;

    /// How far to lift a ray's origin off a surface at `position` along the unit `normal`, world
    /// units, when all that is known is that the position was once rounded to float: one float ulp
    /// of the position, and the rounding of the scene's own frame.
    double clearance(const glm::dvec3& position, const glm::dvec3& normal) const;

    /// For tracing many rays at once, as `intersect()` and `occluded()` do with one. All that
    /// comes from a ray in the frame is in the frame; `scale()` is in frame units per world unit.
    FrameRay frameRay(const glm::dvec3& origin, const glm::dvec3& direction, double tmin,
                      double tmax) const;
    Hit rebuilt(const FrameHit& hit, const glm::dvec3& origin, const glm::dvec3& direction) const;
    glm::dvec3 toFrame(const glm::dvec3& position) const;
    double scale() const;
    RTCSceneTy* embree() const;

    /// The mesh as it was given, triangles without area included.
    const TriangleMesh& mesh() const;

private:
    struct Content;
    explicit RayScene(std::unique_ptr<Content> content);

    std::unique_ptr<Content> content_;
};

} // namespace aolib
