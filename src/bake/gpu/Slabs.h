#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "bake/gpu/LightView.h"

namespace aolib::bake {

/// A direction's slabs: the scene cut across the light into pieces as thick as occluders reach,
/// the one nearest to the light first. Within a reach before a receiver lie what of its own slab is
/// nearer to the light, and a part of the slab before that.
class Slabs {
public:
    /// @param view  whose reach has an end.
    explicit Slabs(const LightView& view);

    int count() const { return count_; }
    /// Slabs from the first one's border to a place: (axis, 1) times (place, 1).
    const glm::vec4& axis() const { return axis_; }
    float coordinate(const glm::vec3& place) const {
        return axis_.x * place.x + axis_.y * place.y + axis_.z * place.z + axis_.w;
    }
    /// From the frame to clip space, which holds a slab alone: what is nearest to the light has the
    /// least depth, from 0 to 1 in the slab.
    glm::mat4 nearest(int slab) const { return toClip(slab, 1.0F); }
    /// The same from behind: what is farthest has the least depth.
    glm::mat4 farthest(int slab) const { return toClip(slab, -1.0F); }

private:
    glm::mat4 toClip(int slab, float sign) const;

    glm::mat4 toLight_;
    glm::vec4 axis_{0.0F};
    int count_ = 1;
};

} // namespace aolib::bake
