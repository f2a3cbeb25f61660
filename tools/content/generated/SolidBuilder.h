#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "content/Model.h"
#include "content/generated/Triangulation.h"

namespace aolib {

/// A recess in a panel, or a hole right through it.
struct Opening {
    Outline outline; ///< counter-clockwise, in the panel's (u, v)
    float depth;     ///< world units into the panel; not used for a hole through a slab
    bool through = false;
};

/// A plane with two unit axes; its normal is u x v.
struct Frame {
    glm::vec3 origin;
    glm::vec3 u;
    glm::vec3 v;

    /// The point (u, v), `depth` behind the plane.
    glm::vec3 at(const glm::vec2& p, float depth = 0.0F) const;
};

Outline rectangle(const glm::vec2& low, const glm::vec2& high);
/// A rectangle that ends in a half circle; `high.y` is the crown.
Outline roundArch(const glm::vec2& low, const glm::vec2& high, int segments);
/// A rectangle that ends in two arcs of a radius as wide as the opening; `springing` is where they
/// start.
Outline pointedArch(const glm::vec2& low, float width, float springing, int segments);
Outline regularPolygon(float radius, int corners, float firstAngle = 0.0F);

/// Collects the faces of solids in one mesh. Every solid function gives a closed surface, faces
/// counter-clockwise from outside; what lies under `place` is moved by it.
class SolidBuilder {
public:
    /// Moves what is added from here on.
    void setPlace(const glm::mat4& place) { place_ = place; }
    const glm::mat4& place() const { return place_; }

    void triangle(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c);
    /// A convex planar polygon, as a fan.
    void polygon(const std::vector<glm::vec3>& corners);
    void quad(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& d);

    /// A flat face with recesses: its front, the reveals and the backs of those that are closed.
    void panel(const Frame& frame, const Outline& outline, const std::vector<Opening>& openings);
    /// A closed slab behind a frame, with recesses in its front and holes through it.
    void slab(const Frame& frame, const Outline& outline, float thickness,
              const std::vector<Opening>& openings = {});
    void box(const glm::vec3& low, const glm::vec3& high);
    /// A prism over an outline in the plane y = 0: x is u, -z is v.
    void prism(const Outline& outline, float bottom, float top);
    /// A frustum over a rectangle, or a hip roof or pyramid where the top has no area.
    void frustum(const glm::vec2& lowHalf, const glm::vec2& highHalf, float bottom, float top);

    /// Points on a grid of rows, joined to quadrilaterals that face (along a row) x (down the
    /// rows). Either direction may wrap round. Smooth where faces meet at less than 35 degrees.
    void surface(const std::vector<std::vector<glm::vec3>>& rows, bool wrapRows, bool wrapColumns);
    /// A surface of revolution about the y axis. The profile (radius, y) has the solid to its left;
    /// it starts and ends on the axis, or is a closed loop.
    void lathe(const Outline& profile, int segments, bool loop = false);
    /// A place on a path: a profile's x goes along `across`, its y along `out`.
    struct Station {
        glm::vec3 centre;
        glm::vec3 across;
        glm::vec3 out;
    };
    /// Carries a closed profile (counter-clockwise) along a path; flat ends where it is open.
    void sweep(const Outline& profile, const std::vector<Station>& path, bool closedPath);

    std::size_t triangleCount() const { return mesh_.triangleCount(); }
    /// The mesh, positions closer than 0.1 mm made equal; the builder is empty afterwards.
    ModelMesh finish(std::string name, const glm::vec3& colour);

private:
    std::uint32_t addVertex(const glm::vec3& position, const glm::vec3& normal);
    void face(const Frame& frame, const Outline& outline, const std::vector<Outline>& holes,
              float depth, bool reversed);
    void strip(const Frame& frame, const Outline& outline, float from, float to, bool inwards);

    glm::mat4 place_{1.0F};
    ModelMesh mesh_;
};

} // namespace aolib
