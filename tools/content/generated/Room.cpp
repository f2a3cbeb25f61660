/// A closed, furnished room of 10 x 3.6 x 8 metres, seen from inside.
#include <array>

#include <glm/ext/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

#include "content/generated/GeneratedScenes.h"
#include "content/generated/SolidBuilder.h"

namespace aolib {
namespace {

constexpr float halfX = 5.0F;
constexpr float halfZ = 4.0F;
constexpr float height = 3.6F;

glm::mat4 standing(float x, float z, float degrees, float y = 0.0F) {
    const glm::mat4 moved = glm::translate(glm::mat4(1.0F), {x, y, z});
    return glm::rotate(moved, glm::radians(degrees), {0, 1, 0});
}

/// Six sides that face inwards, with a door recess, an alcove and two window recesses.
void addShell(std::vector<ModelMesh>& meshes) {
    SolidBuilder builder;
    const auto wall = [](float halfWidth) {
        return rectangle({-halfWidth, 0.0F}, {halfWidth, height});
    };
    const Frame back{{0, 0, -halfZ}, {1, 0, 0}, {0, 1, 0}};
    const Frame front{{0, 0, halfZ}, {-1, 0, 0}, {0, 1, 0}};
    const Frame left{{-halfX, 0, 0}, {0, 0, -1}, {0, 1, 0}};
    const Frame right{{halfX, 0, 0}, {0, 0, 1}, {0, 1, 0}};
    builder.panel(back, wall(halfX), {{roundArch({-1.1F, 0.02F}, {1.1F, 2.7F}, 24), 1.1F}});
    builder.panel(front, wall(halfX), {});
    builder.panel(left, wall(halfZ),
                  {{rectangle({-2.4F, 0.95F}, {-1.0F, 2.6F}), 0.45F},
                   {rectangle({1.0F, 0.95F}, {2.4F, 2.6F}), 0.45F}});
    builder.panel(right, wall(halfZ), {{rectangle({-1.2F, 0.02F}, {-0.1F, 2.3F}), 0.3F}});
    meshes.push_back(builder.finish("walls", {0.78F, 0.74F, 0.66F}));
    builder.quad({-halfX, 0, halfZ}, {halfX, 0, halfZ}, {halfX, 0, -halfZ}, {-halfX, 0, -halfZ});
    meshes.push_back(builder.finish("floor", {0.56F, 0.45F, 0.35F}));
    builder.quad({-halfX, height, -halfZ}, {halfX, height, -halfZ}, {halfX, height, halfZ},
                 {-halfX, height, halfZ});
    meshes.push_back(builder.finish("ceiling", {0.82F, 0.80F, 0.76F}));
}

/// Ceiling beams, skirting, the door's leaf and frame, window sills.
void addWoodwork(std::vector<ModelMesh>& meshes) {
    SolidBuilder builder;
    for (int i = 0; i < 5; ++i) {
        const float x = -4.0F + 2.0F * static_cast<float>(i);
        builder.box({x - 0.12F, height - 0.28F, -halfZ - 0.02F},
                    {x + 0.12F, height + 0.02F, halfZ + 0.02F});
    }
    meshes.push_back(builder.finish("beams", {0.42F, 0.31F, 0.22F}));
    constexpr float thick = 0.03F;
    constexpr float high = 0.14F;
    builder.box({-halfX - 0.02F, -0.02F, -halfZ - 0.02F}, {-1.1F, high, -halfZ + thick});
    builder.box({1.1F, -0.02F, -halfZ - 0.02F}, {halfX + 0.02F, high, -halfZ + thick});
    builder.box({-halfX - 0.02F, -0.02F, halfZ - thick}, {halfX + 0.02F, high, halfZ + 0.02F});
    builder.box({-halfX - 0.02F, -0.02F, -halfZ}, {-halfX + thick, high, halfZ});
    builder.box({halfX - thick, -0.02F, -halfZ}, {halfX + 0.02F, high, -1.32F});
    builder.box({halfX - thick, -0.02F, 0.02F}, {halfX + 0.02F, high, halfZ});
    for (const float z : {-1.26F, -0.04F}) { // door posts and lintel
        builder.box({halfX - 0.05F, -0.02F, z - 0.06F}, {halfX + 0.02F, 2.42F, z + 0.06F});
    }
    builder.box({halfX - 0.05F, 2.3F, -1.32F}, {halfX + 0.02F, 2.44F, 0.02F});
    for (const float z : {-1.7F, 1.7F}) { // sills and glazing bars
        builder.box({-halfX - 0.44F, 0.9F, z - 0.8F}, {-halfX + 0.1F, 0.98F, z + 0.8F});
        builder.box({-halfX - 0.46F, 0.9F, z - 0.03F}, {-halfX - 0.38F, 2.62F, z + 0.03F});
        builder.box({-halfX - 0.46F, 1.8F, z - 0.72F}, {-halfX - 0.38F, 1.86F, z + 0.72F});
    }
    meshes.push_back(builder.finish("joinery", {0.68F, 0.62F, 0.52F}));
    const Frame leaf{{halfX + 0.22F, 0, 0}, {0, 0, 1}, {0, 1, 0}};
    builder.slab(leaf, rectangle({-1.19F, 0.03F}, {-0.11F, 2.29F}), 0.06F,
                 {{rectangle({-1.05F, 0.25F}, {-0.25F, 1.05F}), 0.025F},
                  {rectangle({-1.05F, 1.2F}, {-0.25F, 2.1F}), 0.025F}});
    builder.setPlace(glm::translate(glm::mat4(1.0F), {halfX + 0.18F, 1.1F, -0.2F}));
    builder.lathe({{0, -0.03F}, {0.02F, -0.025F}, {0.03F, 0}, {0.02F, 0.025F}, {0, 0.03F}}, 12);
    meshes.push_back(builder.finish("door", {0.40F, 0.27F, 0.19F}));
}

void addPillars(std::vector<ModelMesh>& meshes) {
    SolidBuilder builder;
    for (const float x : {-2.6F, 2.6F}) {
        for (const float z : {-2.7F, 2.4F}) {
            builder.setPlace(standing(x, z, 0.0F));
            builder.box({-0.27F, -0.02F, -0.27F}, {0.27F, 0.12F, 0.27F});
            builder.box({-0.27F, 3.16F, -0.27F}, {0.27F, 3.34F, 0.27F});
            builder.box({-0.2F, 3.3F, -0.2F}, {0.2F, height + 0.02F, 0.2F});
            builder.lathe({{0.0F, 0.1F},
                           {0.24F, 0.1F},
                           {0.255F, 0.14F},
                           {0.25F, 0.18F},
                           {0.22F, 0.2F},
                           {0.2F, 0.23F},
                           {0.215F, 0.26F},
                           {0.2F, 0.29F},
                           {0.18F, 0.31F},
                           {0.178F, 1.2F},
                           {0.16F, 2.9F},
                           {0.175F, 2.92F},
                           {0.175F, 2.95F},
                           {0.16F, 2.97F},
                           {0.165F, 3.04F},
                           {0.2F, 3.1F},
                           {0.235F, 3.13F},
                           {0.235F, 3.18F},
                           {0.0F, 3.18F}},
                          28);
        }
    }
    meshes.push_back(builder.finish("pillars", {0.76F, 0.73F, 0.68F}));
}

void addTable(std::vector<ModelMesh>& meshes) {
    SolidBuilder builder;
    const glm::mat4 place = standing(0.1F, -0.1F, 8.0F);
    builder.setPlace(place);
    builder.box({-1.1F, 0.72F, -0.6F}, {1.1F, 0.77F, 0.6F});
    builder.box({-0.98F, 0.62F, -0.5F}, {0.98F, 0.73F, 0.5F});
    for (const float x : {-0.92F, 0.92F}) {
        for (const float z : {-0.44F, 0.44F}) {
            builder.setPlace(glm::translate(place, {x, 0, z}));
            builder.lathe({{0.0F, 0.0F},
                           {0.03F, 0.0F},
                           {0.04F, 0.04F},
                           {0.025F, 0.09F},
                           {0.03F, 0.12F},
                           {0.045F, 0.3F},
                           {0.03F, 0.46F},
                           {0.045F, 0.5F},
                           {0.045F, 0.64F},
                           {0.0F, 0.64F}},
                          14);
        }
    }
    meshes.push_back(builder.finish("table", {0.50F, 0.34F, 0.22F}));
    builder.setPlace(glm::translate(place, {-0.35F, 0.765F, 0.05F}));
    builder.lathe({{0.0F, 0.0F},
                   {0.09F, 0.0F},
                   {0.14F, 0.1F},
                   {0.13F, 0.2F},
                   {0.06F, 0.3F},
                   {0.055F, 0.34F},
                   {0.085F, 0.38F},
                   {0.07F, 0.38F},
                   {0.04F, 0.34F},
                   {0.045F, 0.3F},
                   {0.1F, 0.2F},
                   {0.0F, 0.05F}},
                  28);
    meshes.push_back(builder.finish("vase", {0.36F, 0.48F, 0.54F}));
    builder.setPlace(glm::translate(place, {0.42F, 0.765F, -0.1F}));
    builder.lathe({{0.0F, 0.0F},
                   {0.1F, 0.0F},
                   {0.1F, 0.02F},
                   {0.22F, 0.09F},
                   {0.24F, 0.12F},
                   {0.225F, 0.12F},
                   {0.1F, 0.04F},
                   {0.0F, 0.035F}},
                  28);
    meshes.push_back(builder.finish("bowl", {0.72F, 0.60F, 0.42F}));
    for (const glm::vec2& at : {glm::vec2(0.35F, -0.12F), glm::vec2(0.47F, -0.03F)}) {
        builder.setPlace(glm::translate(place, {at.x, 0.81F, at.y}));
        builder.lathe({{0.0F, 0.0F},
                       {0.03F, 0.007F},
                       {0.05F, 0.025F},
                       {0.058F, 0.055F},
                       {0.045F, 0.085F},
                       {0.02F, 0.1F},
                       {0.0F, 0.095F}},
                      16);
    }
    meshes.push_back(builder.finish("fruit", {0.65F, 0.26F, 0.18F}));
}

void addChair(SolidBuilder& builder, const glm::mat4& place) {
    builder.setPlace(place);
    builder.box({-0.22F, 0.43F, -0.22F}, {0.22F, 0.47F, 0.22F});
    for (const float x : {-0.2F, 0.2F}) {
        builder.box({x - 0.02F, 0.0F, 0.16F}, {x + 0.02F, 0.44F, 0.2F});
        builder.box({x - 0.02F, 0.0F, -0.22F}, {x + 0.02F, 0.95F, -0.18F});
        builder.box({x - 0.012F, 0.18F, -0.19F}, {x + 0.012F, 0.21F, 0.17F});
    }
    builder.box({-0.2F, 0.84F, -0.215F}, {0.2F, 0.93F, -0.19F});
    builder.box({-0.2F, 0.62F, -0.21F}, {0.2F, 0.67F, -0.19F});
    for (const float x : {-0.1F, 0.0F, 0.1F}) {
        builder.box({x - 0.015F, 0.66F, -0.208F}, {x + 0.015F, 0.85F, -0.192F});
    }
}

void addFurniture(std::vector<ModelMesh>& meshes) {
    SolidBuilder builder;
    addChair(builder, standing(-0.5F, 0.85F, 172.0F));
    addChair(builder, standing(0.75F, 0.8F, 200.0F));
    addChair(builder, standing(-0.4F, -1.0F, 14.0F));
    addChair(builder, standing(1.95F, -0.35F, -80.0F));
    meshes.push_back(builder.finish("chairs", {0.46F, 0.32F, 0.21F}));
    builder.setPlace(standing(0.1F, 0.0F, 8.0F));
    builder.box({-1.9F, -0.02F, -1.35F}, {1.9F, 0.015F, 1.35F});
    meshes.push_back(builder.finish("rug", {0.52F, 0.25F, 0.22F}));
    const std::array<std::array<float, 5>, 4> crates{{{-4.2F, 3.2F, 10.0F, 0.0F, 0.8F},
                                                      {-3.25F, 3.35F, -12.0F, 0.0F, 0.6F},
                                                      {-4.1F, 3.25F, 38.0F, 0.8F, 0.5F},
                                                      {-4.25F, 2.2F, 3.0F, 0.0F, 0.5F}}};
    for (const auto& [x, z, degrees, y, size] : crates) {
        builder.setPlace(standing(x, z, degrees, y));
        const float half = 0.5F * size;
        builder.box({-half, 0.0F, -half}, {half, size, half});
    }
    meshes.push_back(builder.finish("crates", {0.60F, 0.47F, 0.31F}));
    // A shelf with books on the right wall.
    builder.setPlace(glm::mat4(1.0F));
    builder.box({halfX - 0.36F, 0.0F, 1.3F}, {halfX + 0.01F, 0.1F, 3.1F});
    for (const float z : {1.3F, 3.06F}) {
        builder.box({halfX - 0.36F, 0.0F, z}, {halfX + 0.01F, 2.3F, z + 0.04F});
    }
    for (int i = 0; i < 5; ++i) {
        const float y = 0.1F + 0.54F * static_cast<float>(i);
        builder.box({halfX - 0.35F, y, 1.32F}, {halfX + 0.01F, y + 0.03F, 3.08F});
    }
    meshes.push_back(builder.finish("shelf", {0.44F, 0.31F, 0.21F}));
    for (int i = 0; i < 30; ++i) {
        const int board = i / 10;
        const auto step = static_cast<float>(i % 10);
        const float y = 0.13F + 0.54F * static_cast<float>(board);
        const float z = 1.4F + 0.11F * step + 0.2F * static_cast<float>(board);
        const float tall = 0.26F + 0.05F * static_cast<float>((i * 7) % 4);
        builder.box({halfX - 0.3F + 0.02F * static_cast<float>((i * 5) % 3), y, z},
                    {halfX - 0.04F, y + tall, z + 0.06F + 0.012F * static_cast<float>(i % 3)});
    }
    meshes.push_back(builder.finish("books", {0.35F, 0.38F, 0.36F}));
    // In the alcove: a bench with a chest beside it, and a ball on the floor before it.
    builder.box({-0.95F, 0.38F, -halfZ - 1.0F}, {0.95F, 0.45F, -halfZ - 0.5F});
    for (const float x : {-0.85F, 0.79F}) {
        builder.box({x, 0.0F, -halfZ - 0.95F}, {x + 0.06F, 0.39F, -halfZ - 0.55F});
    }
    meshes.push_back(builder.finish("bench", {0.50F, 0.36F, 0.24F}));
    builder.setPlace(standing(3.9F, -3.2F, 0.0F));
    builder.lathe({{0.0F, 0.0F},
                   {0.3F, 0.0F},
                   {0.42F, 0.3F},
                   {0.45F, 0.62F},
                   {0.48F, 0.66F},
                   {0.4F, 0.66F},
                   {0.36F, 0.3F},
                   {0.0F, 0.25F}},
                  32);
    meshes.push_back(builder.finish("tub", {0.55F, 0.42F, 0.30F}));
}

} // namespace

Model buildRoom() {
    Model model{"room", {}};
    addShell(model.meshes);
    addWoodwork(model.meshes);
    addPillars(model.meshes);
    addTable(model.meshes);
    addFurniture(model.meshes);
    return model;
}

std::vector<NamedCamera> roomCameras() {
    return {{"corner", {-4.3F, 1.9F, 1.3F}, {1.2F, 0.9F, -1.6F}, {0, 1, 0}, 62.0F, 0.05F, 40.0F},
            {"table", {1.9F, 1.55F, 2.2F}, {-0.3F, 0.75F, -0.9F}, {0, 1, 0}, 55.0F, 0.05F, 40.0F},
            {"door", {-1.2F, 1.65F, -3.3F}, {4.2F, 1.1F, 1.0F}, {0, 1, 0}, 60.0F, 0.05F, 40.0F}};
}

} // namespace aolib
