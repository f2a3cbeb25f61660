#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace aolib {

/// Triangles with UVs without overlaps: what the bakers are tried on.
struct UvMesh {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals; ///< unit
    std::vector<glm::vec2> uvs;     ///< in [0,1], v upwards
    std::vector<std::uint32_t> indices;
};

/// A rectangle of a map.
struct UvRect {
    glm::vec2 low{0.0F};
    glm::vec2 high{1.0F};
};

/// A quad of `cells` by `cells` squares, u along `across`, v along `along`.
void addUvQuad(UvMesh& mesh, const glm::vec3& corner, const glm::vec3& across,
               const glm::vec3& along, int cells, const UvRect& rect = {});

/// A sphere by longitude (u) and latitude (v): its poles are stretched, its first meridian a seam.
void addUvSphere(UvMesh& mesh, const glm::vec3& centre, float radius, int segments, int rings,
                 const UvRect& rect = {});

/// The six sides of a box, one chart each in a grid of 3 by 2 with gaps.
/// @param inwards  seen from inside.  @param lid  with the upper side.
void addUvBox(UvMesh& mesh, const glm::vec3& low, const glm::vec3& high, int cells,
              const UvRect& rect = {}, bool inwards = false, bool lid = true);

/// A ball with bumps, about `triangles` of them, in one chart like the sphere's: occlusion of every
/// scale at any size of mesh.
UvMesh bumpySphere(int triangles);

/// The shapes that `aolib bake` knows by name: "uv-sphere" (alone), "uv-box" (alone), "uv-shapes"
/// (a sphere in an open box).
std::vector<std::string> uvShapeNames();

/// The shape of a name; no triangles where there is none.
UvMesh uvShape(std::string_view name);

} // namespace aolib
