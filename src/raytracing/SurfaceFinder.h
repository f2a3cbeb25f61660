#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include <aolib/AbstractTexelTracer.h>
#include <glm/vec3.hpp>

#include "raytracing/RayScene.h"

namespace aolib {

/// Finds what texels of a request see: one ray each, from the cube map's centre through the texel's
/// centre. A surface that goes through the cube map's centre itself is not seen.
class SurfaceFinder {
public:
    static constexpr std::size_t packet = 16; ///< texels at a time

    struct Texel {
        int x = 0; ///< of the face
        int y = 0;
    };
    struct Seen {
        Hit hit;                ///< `u` and `v` apart, on the texel's ray in double precision
        glm::dvec3 normal{0.0}; ///< of the hit, turned to the centre
    };
    using SeenList = std::array<std::optional<Seen>, packet>;

    SurfaceFinder(const RayScene& scene, const TexelRequest& request);

    /// What up to `packet` texels see. Close ones are faster.
    SeenList find(std::span<const Texel> texels) const;

private:
    glm::dvec3 direction(const Texel& texel) const;
    Seen seen(const Hit& hit, const glm::dvec3& direction) const;

    const RayScene& scene_;
    glm::dvec3 centre_;
    double nearest_; ///< where rays start, world units
    double faceSize_;
    glm::dvec3 forward_;
    glm::dvec3 right_;
    glm::dvec3 up_;
};

} // namespace aolib
