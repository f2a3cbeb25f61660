#pragma once

#include <cstdint>
#include <limits>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <aolib/bake/BakeOptions.h>

#include "scene/Bounds.h"

namespace aolib::bake {

/// A scene's own frame for the GPU: centred, its bounding sphere's radius one.
class BakeFrame {
public:
    explicit BakeFrame(const Bounds& bounds);

    glm::vec3 toFrame(const glm::dvec3& position) const {
        return glm::vec3((position - centre_) * scale_);
    }
    /// Frame units per world unit.
    double scale() const { return scale_; }
    /// Half the sides of the bounding box, frame units.
    const glm::dvec3& halfExtent() const { return halfExtent_; }

private:
    glm::dvec3 centre_;
    double scale_;
    glm::dvec3 halfExtent_;
};

/// A box in the frame.
struct FrameBox {
    glm::dvec3 centre{0.0};
    glm::dvec3 half{0.0}; ///< its sides
};

/// Directions towards the light, unit length, uniform over the sky: Sobol's points scrambled, so
/// that whatever number of them has been used so far is spread well.
/// @param up  of `Sky::Dome`, unit length.
glm::dvec3 lightDirection(Sky sky, const glm::dvec3& up, std::uint32_t seed, std::uint32_t index);

/// The parallel projection along a direction that just holds a box across it, and the whole scene
/// along it: what lies beside the box takes no light from it. It is turned about the direction and
/// moved by less than a pixel, by chance, so that no texel is missed from everywhere.
struct LightView {
    glm::dvec3 direction{0.0}; ///< towards the light
    glm::mat4 toClip{1.0F};    ///< from the frame; the light sees what has the least depth
    glm::dvec2 pixel{0.0};     ///< a pixel's sides, frame units
    double phase = 0.0;        ///< where slabs begin, 0 to 1, by chance
    /// How far from a receiver occluders count, frame units.
    double reach = std::numeric_limits<double>::infinity();
};

LightView lightView(const BakeFrame& frame, const FrameBox& box, const glm::dvec3& direction,
                    int size, std::uint32_t seed, std::uint32_t index);

} // namespace aolib::bake
