#include "bake/gpu/Slabs.h"

#include <algorithm>
#include <cmath>

namespace aolib::bake {

Slabs::Slabs(const LightView& view) : toLight_(view.toClip) {
    // Depths of clip space are -1 to 1 for the whole scene.
    const glm::dvec4 depth(view.toClip[0].z, view.toClip[1].z, view.toClip[2].z,
                           double{view.toClip[3].z} + 1.0);
    const double perUnit = glm::length(glm::dvec3(depth));
    const double whole = 2.0 / perUnit;
    const double thickness = std::min(view.reach, whole);
    // Where their borders lie is left to chance; a scene that fits into one needs no border.
    const double phase = thickness < whole ? view.phase : 0.0;
    const glm::dvec4 axis = depth / (perUnit * thickness);
    axis_ = glm::vec4(glm::vec3(axis), static_cast<float>(axis.w + phase));
    count_ = static_cast<int>(std::ceil(whole / thickness + phase));
}

glm::mat4 Slabs::toClip(int slab, float sign) const {
    glm::mat4 matrix = toLight_;
    for (int column = 0; column < 3; ++column) {
        matrix[column].z = sign * 2.0F * axis_[column];
    }
    matrix[3].z = sign * (2.0F * (axis_.w - float(slab)) - 1.0F);
    return matrix;
}

} // namespace aolib::bake
