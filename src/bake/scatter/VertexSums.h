#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "bake/geometry/BakeGeometry.h"
#include "bake/gpu/LightView.h"
#include "bake/scatter/PointWeights.h"
#include "bake/vertices/VertexWeld.h"

namespace aolib::bake {

/// Sums of scattered points at vertices: a pixel that light sees is shared among the corners of its
/// triangle by its barycentric weights b_k, so that a vertex's sum goes towards the integral of
/// b_k times the light over the triangles about it: the right side of a fit of linear elements.
class VertexSums {
public:
    /// @param ground  up and height in the frame; up 0 for none.
    VertexSums(const BakeGeometry& geometry, const BakeFrame& frame, const VertexWeld& weld,
               const glm::vec4& ground);

    /// Adds what a direction lights.
    /// @param picture  place in the frame, number of the triangle from 1, 0 for none.
    void add(const std::vector<glm::vec4>& picture, const LightView& view);

    /// Per number of the weld: weight and weighed direction, square frame units.
    const std::vector<glm::dvec4>& light() const { return light_; }
    /// Per number: the integral of b_k, a third of the area about it, square frame units.
    const std::vector<double>& areas() const { return areas_; }

private:
    /// Weights of the second and third corner are `along * (p - origin)`.
    struct Triangle {
        glm::vec3 origin{0.0F};
        glm::vec3 alongSecond{0.0F};
        glm::vec3 alongThird{0.0F};
        std::array<std::uint32_t, 3> corners{VertexWeld::unused, VertexWeld::unused,
                                             VertexWeld::unused};
    };
    void addTriangle(const Surface& surface, const TriangleName& name, const BakeFrame& frame,
                     const VertexWeld& weld, Triangle& triangle);

    PointWeights weights_;
    std::vector<Triangle> triangles_;
    std::vector<glm::dvec4> light_;
    std::vector<double> areas_;
};

} // namespace aolib::bake
