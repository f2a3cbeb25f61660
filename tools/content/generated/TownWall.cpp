/// The wall about the town: crenellated curtains, round towers, and the gate in the south.
#include <glm/ext/matrix_transform.hpp>
#include <glm/gtc/constants.hpp>

#include "content/generated/TownParts.h"

namespace aolib::town {
namespace {

constexpr float reach = 80.0F; ///< from the middle of the town to the middle of its wall
constexpr float walk = 6.0F;   ///< height of the wall walk
constexpr float half = 1.3F;   ///< half the wall's thickness

/// The outline of a parapet with merlons, from one end to the other.
Outline battlement(float from, float to, float pitch) {
    Outline top;
    for (float u = from + 0.5F * pitch; u + 0.5F * pitch < to; u += pitch) {
        const float gap = 0.25F * pitch;
        top.insert(top.end(), {{u - gap, 8.0F}, {u - gap, 7.1F}, {u + gap, 7.1F}, {u + gap, 8.0F}});
    }
    Outline outline{{from, walk - 0.2F}, {to, walk - 0.2F}, {to, 8.0F}};
    outline.insert(outline.end(), top.rbegin(), top.rend());
    outline.emplace_back(from, 8.0F);
    return outline;
}

/// A stretch of wall along x, its outside towards +z.
void addCurtain(SolidBuilder& stone, float from, float to) {
    stone.box({from, -0.1F, -half}, {to, walk, half});
    stone.slab({{0, 0, half + 0.05F}, {1, 0, 0}, {0, 1, 0}}, battlement(from, to, 12.4F), 0.55F);
}

void addTower(SolidBuilder& stone, SolidBuilder& roof, const glm::vec2& at, float radius,
              float height) {
    const glm::mat4 place = glm::translate(glm::mat4(1.0F), {at.x, 0.0F, at.y});
    stone.setPlace(place);
    roof.setPlace(place);
    stone.lathe({{0.0F, -0.1F},
                 {radius + 0.3F, -0.1F},
                 {radius, height - 1.4F},
                 {radius + 0.5F, height - 0.9F},
                 {radius + 0.5F, height},
                 {0.0F, height}},
                8);
    roof.lathe({{0.0F, height - 0.3F},
                {radius + 0.9F, height - 0.3F},
                {radius * 0.45F, height + 2.6F},
                {0.0F, height + 6.2F}},
               8);
}

void addGate(SolidBuilder& stone, SolidBuilder& roof, SolidBuilder& wood) {
    stone.setPlace(glm::translate(glm::mat4(1.0F), {0.0F, 0.0F, reach}));
    const Frame outside{{0, 0, 2.6F}, {1, 0, 0}, {0, 1, 0}};
    const Opening way{roundArch({-2.7F, 0.0F}, {2.7F, 6.2F}, 8), 0, true};
    // The passage: the opening reaches the ground, so the outline goes round it.
    Outline outline{{-5.5F, -0.1F}};
    outline.emplace_back(-2.7F, -0.1F);
    for (std::size_t i = way.outline.size(); i-- > 2;) {
        outline.push_back(way.outline[i]);
    }
    outline.insert(outline.end(), {{2.7F, -0.1F}, {5.5F, -0.1F}, {5.5F, 10.5F}, {-5.5F, 10.5F}});
    stone.slab(outside, outline, 5.2F);
    roof.setPlace(stone.place());
    roof.frustum({6.1F, 3.2F}, {2.6F, 0.0F}, 10.4F, 14.2F);
    wood.setPlace(stone.place());
    for (int side = -1; side <= 1; side += 2) { // two open leaves
        const auto x = static_cast<float>(side) * 2.55F;
        wood.box({x - 0.09F, 0.05F, -5.0F}, {x + 0.09F, 3.4F, -2.5F});
    }
}

} // namespace

void addCityWall(std::vector<ModelMesh>& meshes) {
    SolidBuilder stone;
    SolidBuilder roof;
    SolidBuilder wood;
    for (int side = 0; side < 4; ++side) {
        const glm::mat4 turned = glm::rotate(
            glm::mat4(1.0F), glm::half_pi<float>() * static_cast<float>(side), {0, 1, 0});
        stone.setPlace(glm::translate(turned, {0.0F, 0.0F, reach}));
        if (side == 0) { // the south side is parted by the gate
            addCurtain(stone, -reach, -5.2F);
            addCurtain(stone, 5.2F, reach);
        } else {
            addCurtain(stone, -reach, reach);
        }
    }
    for (const float x : {-reach, reach}) {
        for (const float z : {-reach, reach}) {
            addTower(stone, roof, {x, z}, 4.6F, 11.5F);
        }
        addTower(stone, roof, {x, 0.0F}, 3.6F, 9.8F);
    }
    addTower(stone, roof, {-6.8F, reach + 1.4F}, 3.0F, 12.5F);
    addTower(stone, roof, {6.8F, reach + 1.4F}, 3.0F, 12.5F);
    addGate(stone, roof, wood);
    meshes.push_back(stone.finish("city wall", {0.60F, 0.57F, 0.52F}));
    meshes.push_back(roof.finish("tower roofs", {0.46F, 0.28F, 0.22F}));
    meshes.push_back(wood.finish("gate leaves", {0.38F, 0.29F, 0.21F}));
}

} // namespace aolib::town
