#include "bake/scatter/CpuSplatter.h"

#include <cstddef>

namespace aolib::bake {

void CpuSplatter::add(const std::vector<glm::vec4>& picture, const LightView& view,
                      std::span<glm::vec4> light) const {
    const glm::vec4 unit(glm::vec3(view.direction), 1.0F);
    const glm::vec2 size(stack_.mapSize);
    for (const glm::vec4& pixel : picture) {
        if (pixel.z == 0.0F) {
            continue;
        }
        const auto triangle = static_cast<std::size_t>(pixel.z) - 1;
        const PointShape& shape = shapes_[triangle];
        const int row = shape.map - stack_.first;
        if (shape.facet == 0.0F || row < 0 || row >= stack_.count) {
            continue;
        }
        const float weight = weights_.of(triangle, glm::vec2(pixel), view);
        if (weight > 0.0F) {
            const glm::vec2 place = glm::vec2(pixel) * size + glm::vec2(0.0F, float(row) * size.y);
            target_.scatter(place, shape, [&](std::size_t texel, float share) {
                light[texel] += unit * (share * weight);
            });
        }
    }
}

} // namespace aolib::bake
