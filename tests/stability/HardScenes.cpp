#include "HardScenes.h"

#include <random>

#include "SmallScene.h"

namespace aolib {

Model court() {
    Model model;
    addQuad(model, {-8, 0, -8}, {-8, 0, 8}, {8, 0, 8}, {8, 0, -8});
    addBox(model, {-8, 0, -8}, {8, 5, -7});
    addBox(model, {-4, 0, -5}, {-1, 3, -3});
    addBox(model, {1, 0, -3}, {4, 2, -1});
    return model;
}

NamedCamera courtCamera() {
    NamedCamera camera;
    camera.eye = {0, 3, 7};
    camera.target = {0, 3, -8};
    camera.fovyDeg = 60.0F;
    camera.near = 0.125F;
    camera.far = 64.0F;
    return camera;
}

Model scaled(Model model, float factor) {
    for (ModelMesh& mesh : model.meshes) {
        for (glm::vec3& p : mesh.positions) {
            p *= factor;
        }
    }
    return model;
}

NamedCamera scaled(NamedCamera camera, float factor) {
    camera.eye *= factor;
    camera.target *= factor;
    camera.near *= factor;
    camera.far *= factor;
    return camera;
}

Model turned(Model model, const glm::mat3& rotation) {
    for (ModelMesh& mesh : model.meshes) {
        for (glm::vec3& p : mesh.positions) {
            p = rotation * p;
        }
    }
    return model;
}

NamedCamera turned(NamedCamera camera, const glm::mat3& rotation) {
    camera.eye = rotation * camera.eye;
    camera.target = rotation * camera.target;
    camera.up = rotation * camera.up;
    return camera;
}

Model moved(Model model, const glm::vec3& by, bool inTransforms) {
    for (ModelMesh& mesh : model.meshes) {
        if (inTransforms) {
            mesh.transform[3] += glm::vec4(by, 0.0F);
            continue;
        }
        for (glm::vec3& p : mesh.positions) {
            p += by;
        }
    }
    return model;
}

NamedCamera moved(NamedCamera camera, const glm::vec3& by) {
    camera.eye += by;
    camera.target += by;
    return camera;
}

Model fins(float thickness, float spacing) {
    Model model;
    addQuad(model, {-4, 0, -4}, {-4, 0, 4}, {4, 0, 4}, {4, 0, -4});
    for (float x = -2.0F; x <= 2.0F; x += spacing) {
        addBox(model, {x, 0, -2}, {x + thickness, 1, 2});
    }
    return model;
}

Model leaves(int count, float size) {
    Model model;
    addQuad(model, {-4, 0, -4}, {-4, 0, 4}, {4, 0, 4}, {4, 0, -4});
    std::mt19937 generator(7);
    const auto random = [&](float low, float high) {
        return low + (high - low) * static_cast<float>(generator() >> 8U) * 0x1p-24F;
    };
    ModelMesh mesh;
    for (int i = 0; i < count; ++i) {
        const glm::vec3 centre{random(-2, 2), random(0.05F, 1.5F), random(-2, 2)};
        const glm::vec3 axis = glm::normalize(
            glm::vec3(random(-1, 1), random(-1, 1), random(-1, 1)) + glm::vec3(1e-3F));
        const glm::mat3 turn(glm::rotate(glm::mat4(1.0F), random(0, 6.28F), axis));
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        mesh.positions.push_back(centre - 0.5F * size * (turn[0] + turn[1]));
        mesh.positions.push_back(centre + 0.5F * size * (turn[0] - turn[1]));
        mesh.positions.push_back(centre + 0.5F * size * (turn[0] + turn[1]));
        mesh.positions.push_back(centre + 0.5F * size * (turn[1] - turn[0]));
        for (const std::uint32_t k : {0U, 1U, 2U, 0U, 2U, 3U}) {
            mesh.indices.push_back(first + k);
        }
    }
    model.meshes.push_back(std::move(mesh));
    return model;
}

} // namespace aolib
