/// The box of Cornell's radiosity experiments, in units of a tenth of its width, open at the front.
#include <glm/ext/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

#include "content/generated/GeneratedScenes.h"
#include "content/generated/SolidBuilder.h"

namespace aolib {
namespace {

constexpr float half = 5.0F;
constexpr float height = 10.0F;

ModelMesh block(const char* name, const glm::vec3& centre, const glm::vec3& size, float degrees) {
    SolidBuilder builder;
    const glm::mat4 moved = glm::translate(glm::mat4(1.0F), centre);
    builder.setPlace(glm::rotate(moved, glm::radians(degrees), {0, 1, 0}));
    builder.box({-0.5F * size.x, 0, -0.5F * size.z}, {0.5F * size.x, size.y, 0.5F * size.z});
    return builder.finish(name, {0.78F, 0.76F, 0.7F});
}

} // namespace

Model buildCornell() {
    Model model{"cornell", {}};
    SolidBuilder builder;
    builder.quad({-half, 0, half}, {half, 0, half}, {half, 0, -half}, {-half, 0, -half});
    builder.quad({-half, height, -half}, {half, height, -half}, {half, height, half},
                 {-half, height, half});
    builder.quad({-half, 0, -half}, {half, 0, -half}, {half, height, -half},
                 {-half, height, -half});
    model.meshes.push_back(builder.finish("floor, ceiling, back", {0.78F, 0.76F, 0.7F}));
    builder.quad({-half, 0, half}, {-half, 0, -half}, {-half, height, -half},
                 {-half, height, half});
    model.meshes.push_back(builder.finish("left wall", {0.63F, 0.12F, 0.1F}));
    builder.quad({half, 0, -half}, {half, 0, half}, {half, height, half}, {half, height, -half});
    model.meshes.push_back(builder.finish("right wall", {0.16F, 0.42F, 0.13F}));
    model.meshes.push_back(block("tall block", {-1.6F, 0, -1.5F}, {3, 6, 3}, 18.0F));
    model.meshes.push_back(block("short block", {1.8F, 0, 1.6F}, {3, 3, 3}, -17.0F));
    return model;
}

std::vector<NamedCamera> cornellCameras() {
    return {{"front", {0, 5, 18.5F}, {0, 4.9F, 0}, {0, 1, 0}, 40.0F, 0.1F, 60.0F},
            {"inside", {3.9F, 7.5F, 4.5F}, {-1.5F, 1.5F, -2.5F}, {0, 1, 0}, 60.0F, 0.1F, 60.0F}};
}

} // namespace aolib
