#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include <aolib/AbstractTexelTracer.h>
#include <glm/vec3.hpp>

#include "raytracing/RayScene.h"

namespace aolib {

/// Finds what the texels of a request see, a ray each: from the cube map's centre through the
/// texel's centre, or along the request's lines of sight. A surface that goes through the cube
/// map's centre itself is not seen.
class SurfaceFinder {
public:
    static constexpr std::size_t packet = 16; ///< texels at a time

    struct Texel {
        int x = 0; ///< of the request's rectangle
        int y = 0;
    };
    struct Seen {
        Hit hit;                   ///< `u` and `v` apart, on the texel's ray in double precision
        glm::dvec3 normal{0.0};    ///< of the hit, turned to the viewer
        glm::dvec3 shading{0.0};   ///< the normal that visibility is about
        glm::dvec3 direction{0.0}; ///< in which it was seen, of length 1
    };
    using SeenList = std::array<std::optional<Seen>, packet>;

    /// The request must outlive it.
    SurfaceFinder(const RayScene& scene, const TexelRequest& request);

    /// What up to `packet` texels see. Close ones are faster.
    SeenList find(std::span<const Texel> texels) const;

private:
    struct Ray {
        glm::dvec3 origin;
        glm::dvec3 direction;
        double nearest; ///< where it starts and ends, world units
        double farthest;
    };
    Ray ray(const Texel& texel) const;
    Seen seen(const Hit& hit, const Ray& ray) const;

    const RayScene& scene_;
    const TexelRequest& request_;
    glm::dvec3 centre_;
    double nearest_; ///< where the rays of a face's texels start, world units
    glm::dvec3 forward_;
    glm::dvec3 right_;
    glm::dvec3 up_;
};

} // namespace aolib
