#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <aolib/Status.h>
#include <aolib/bake/BakeScene.h>

#include "scene/Bounds.h"
#include "scene/TriangleMesh.h"

namespace aolib::bake {

/// A place on a surface.
struct SurfacePoint {
    glm::dvec3 position{0.0};
    glm::dvec3 normal{0.0}; ///< shading normal, unit length: W is about it
    glm::dvec3 plane{0.0};  ///< the triangle's own normal, unit length, turned to the same side
};

/// The vector made one unit long; zero where it has no direction.
glm::dvec3 unitOrZero(const glm::dvec3& v);

/// A triangle of a scene: which surface's, and which of it.
struct TriangleName {
    std::uint32_t surface = 0;
    std::uint32_t triangle = 0;
};

/// A scene that has been checked, its triangles numbered through.
class BakeGeometry {
public:
    /// Errors: InvalidPosition, InvalidIndex, InvalidNormal, IncompletePrimitive (naming the
    /// surface), EmptyMesh (no triangles at all), InvalidOption (`up`, `ground`, a map's number).
    static Result<BakeGeometry> create(BakeScene scene);

    const BakeScene& scene() const { return scene_; }
    const glm::dvec3& up() const { return up_; }
    /// Of all vertices that triangles use, without the ground.
    const Bounds& bounds() const { return bounds_; }

    std::size_t triangleCount() const { return firstTriangle_.back(); }
    TriangleName triangle(std::size_t number) const;
    std::size_t numberOf(const TriangleName& name) const {
        return firstTriangle_[name.surface] + name.triangle;
    }

    /// The point of a triangle with barycentric weights `b1`, `b2` of its second and third vertex,
    /// or nothing where the triangle has neither an area nor a normal.
    std::optional<SurfacePoint> point(const TriangleName& name, double b1, double b2) const;

    /// All triangles, numbered as here, for Embree. The ground is not among them.
    TriangleMesh occluders() const;

private:
    BakeGeometry() = default;
    AoStatus check() const;

    BakeScene scene_;
    glm::dvec3 up_{0.0, 1.0, 0.0};
    Bounds bounds_;
    std::vector<std::size_t> firstTriangle_; ///< per surface, and the total at the end
};

} // namespace aolib::bake
