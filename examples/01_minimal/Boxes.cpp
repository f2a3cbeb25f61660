#include "Boxes.h"

namespace {

/// A parallelogram; seen from where a, b and the normal form a right-handed system it faces you.
void addQuad(Triangles& to, glm::vec3 corner, glm::vec3 a, glm::vec3 b, glm::vec3 normal) {
    const auto first = static_cast<std::uint32_t>(to.positions.size());
    for (const glm::vec3& position : {corner, corner + a, corner + a + b, corner + b}) {
        to.positions.push_back(position);
        to.normals.push_back(normal);
    }
    for (const std::uint32_t index : {0U, 1U, 2U, 0U, 2U, 3U}) {
        to.indices.push_back(first + index);
    }
}

void addBox(Triangles& to, glm::vec3 low, glm::vec3 high) {
    for (int axis = 0; axis < 3; ++axis) {
        glm::vec3 n(0.0F);
        glm::vec3 a(0.0F);
        glm::vec3 b(0.0F);
        n[axis] = 1.0F;
        a[(axis + 1) % 3] = high[(axis + 1) % 3] - low[(axis + 1) % 3];
        b[(axis + 2) % 3] = high[(axis + 2) % 3] - low[(axis + 2) % 3];
        addQuad(to, high - a - b, a, b, n);
        addQuad(to, low, b, a, -n);
    }
}

} // namespace

Triangles groundWithBoxes() {
    Triangles scene;
    addQuad(scene, {-8.0F, 0.0F, -8.0F}, {0.0F, 0.0F, 16.0F}, {16.0F, 0.0F, 0.0F},
            {0.0F, 1.0F, 0.0F});
    addBox(scene, {-2.6F, 0.0F, -1.4F}, {-0.4F, 2.4F, 0.6F});
    addBox(scene, {-0.4F, 0.0F, -1.4F}, {1.6F, 1.0F, 1.0F});
    addBox(scene, {0.1F, 1.0F, -0.9F}, {1.0F, 1.7F, 0.1F});
    addBox(scene, {2.4F, 0.0F, 0.8F}, {3.2F, 0.8F, 1.6F});
    addBox(scene, {-1.2F, 0.0F, 1.7F}, {-0.2F, 0.5F, 2.7F});
    addBox(scene, {-3.4F, 0.0F, 1.6F}, {-3.1F, 2.8F, 1.9F});
    return scene;
}
