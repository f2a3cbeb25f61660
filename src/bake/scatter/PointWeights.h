#pragma once

#include <cstddef>
#include <vector>

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "bake/geometry/BakeGeometry.h"
#include "bake/gpu/LightView.h"

namespace aolib::bake {

/// How much light falls on a pixel of a picture from a direction, times the Jacobian of texels by
/// pixels, where its triangle and its place in the map are known. What
/// shaders/bake/scatter_surface.frag says on the GPU, where the Jacobian comes by differences.
class PointWeights {
public:
    struct Settings {
        glm::ivec2 mapSize{0};  ///< texels
        float density = 0.0F;   ///< square texels per square frame unit; 0: each triangle's own
        glm::vec4 ground{0.0F}; ///< up and height in the frame; up 0 for none
        /// Points are given by the weights of the triangle's second and third corner instead of u
        /// and v, which may be anything.
        bool barycentric = false;
    };

    PointWeights(const BakeGeometry& geometry, const BakeFrame& frame, const Settings& settings);

    /// @param triangle  by number. @param uv  in it.
    float of(std::size_t triangle, const glm::vec2& uv, const LightView& view) const;

private:
    /// All that depends on the place is linear in u and v.
    struct Triangle {
        glm::vec2 middle{0.0F}; ///< u, v
        glm::vec3 normal{0.0F}; ///< shading normal there; any length
        glm::vec3 normalAlongU{0.0F};
        glm::vec3 normalAlongV{0.0F};
        glm::vec3 plane{0.0F};  ///< unit length
        glm::vec3 height{0.0F}; ///< above the ground in the middle, frame units; and along u, v
        float density = 0.0F;   ///< square texels per square frame unit
    };
    static Triangle makeTriangle(const Surface& surface, std::uint32_t number,
                                 const BakeFrame& frame, const Settings& settings);

    glm::vec3 up_;
    std::vector<Triangle> triangles_;
};

} // namespace aolib::bake
