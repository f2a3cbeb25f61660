/// What stands on the market square and in the yards: fountain, stalls, benches, trees.
#include <cmath>

#include <glm/ext/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

#include "content/generated/TownParts.h"

namespace aolib::town {
namespace {

void addFountain(std::vector<ModelMesh>& meshes) {
    SolidBuilder stone;
    SolidBuilder water;
    stone.prism(regularPolygon(4.6F, 8, 0.3927F), -0.1F, 0.15F);
    stone.prism(regularPolygon(4.1F, 8, 0.3927F), 0.1F, 0.3F);
    stone.lathe(
        {{3.3F, 0.2F}, {3.55F, 0.5F}, {3.6F, 1.0F}, {3.45F, 1.1F}, {3.15F, 1.1F}, {3.1F, 0.2F}}, 12,
        true);
    stone.lathe({{0.0F, 0.2F},
                 {0.75F, 0.2F},
                 {0.75F, 0.6F},
                 {0.38F, 0.8F},
                 {0.3F, 2.2F},
                 {0.5F, 2.4F},
                 {1.55F, 2.85F},
                 {1.6F, 3.0F},
                 {1.45F, 3.0F},
                 {0.3F, 2.7F},
                 {0.24F, 3.6F},
                 {0.36F, 3.8F},
                 {0.0F, 4.35F}},
                8);
    water.prism(regularPolygon(3.3F, 12), 0.25F, 0.8F);
    meshes.push_back(stone.finish("fountain", {0.66F, 0.65F, 0.62F}));
    meshes.push_back(water.finish("fountain water", {0.35F, 0.47F, 0.52F}));
}

void addStall(SolidBuilder& wood, SolidBuilder& cloth, const glm::vec2& at, float degrees) {
    const glm::mat4 moved = glm::translate(glm::mat4(1.0F), {at.x, 0.0F, at.y});
    const glm::mat4 place = glm::rotate(moved, glm::radians(degrees), {0, 1, 0});
    wood.setPlace(place);
    cloth.setPlace(place);
    for (const float x : {-1.4F, 1.4F}) {
        wood.box({x - 0.06F, -0.1F, -0.86F}, {x + 0.06F, 2.55F, -0.74F});
        wood.box({x - 0.06F, -0.1F, 0.74F}, {x + 0.06F, 2.15F, 0.86F});
    }
    wood.box({-1.5F, 0.85F, -0.7F}, {1.5F, 0.95F, 0.72F});
    wood.box({-1.2F, 0.94F, -0.5F}, {-0.3F, 1.25F, 0.3F});
    const Frame side{{1.7F, 0, 0}, {0, 0, -1}, {0, 1, 0}};
    cloth.slab(side, {{-1.2F, 1.98F}, {1.1F, 2.56F}, {1.1F, 2.64F}, {-1.2F, 2.06F}}, 3.4F);
}

} // namespace

void addSquare(std::vector<ModelMesh>& meshes) {
    addFountain(meshes);
    SolidBuilder wood;
    SolidBuilder cloth;
    addStall(wood, cloth, {-13.0F, -9.0F}, 90.0F);
    addStall(wood, cloth, {-13.2F, -13.6F}, 88.0F);
    addStall(wood, cloth, {-12.0F, 12.5F}, 160.0F);
    addStall(wood, cloth, {12.0F, 13.5F}, 200.0F);
    for (const float x : {-7.5F, 7.5F}) {
        wood.setPlace(glm::translate(glm::mat4(1.0F), {x, 0.0F, 4.5F}));
        wood.box({-0.25F, 0.42F, -1.1F}, {0.25F, 0.52F, 1.1F});
        wood.box({-0.2F, -0.1F, -0.9F}, {0.2F, 0.44F, -0.7F});
        wood.box({-0.2F, -0.1F, 0.7F}, {0.2F, 0.44F, 0.9F});
    }
    meshes.push_back(wood.finish("stalls and benches", {0.47F, 0.36F, 0.26F}));
    meshes.push_back(cloth.finish("stall cloths", {0.70F, 0.42F, 0.33F}));
}

void addTree(SolidBuilder& trunks, SolidBuilder& crowns, const glm::vec2& at, bool slender,
             Pcg& random) {
    const float size = random.uniform(0.85F, 1.25F);
    glm::mat4 place = glm::translate(glm::mat4(1.0F), {at.x, 0.0F, at.y});
    place = glm::rotate(place, random.uniform(0.0F, 3.0F), {0, 1, 0});
    trunks.setPlace(place);
    crowns.setPlace(place);
    if (slender) {
        trunks.prism(regularPolygon(0.16F * size, 5), -0.1F, 1.2F);
        crowns.lathe({{0.0F, 0.9F},
                      {0.75F * size, 1.2F},
                      {0.95F * size, 2.6F * size},
                      {0.55F * size, 5.4F * size},
                      {0.0F, 7.6F * size}},
                     6);
        return;
    }
    const float fork = 2.3F * size;
    trunks.prism(regularPolygon(0.22F * size, 5), -0.1F, fork + 0.6F);
    crowns.lathe({{0.0F, fork},
                  {1.5F * size, fork + 0.5F * size},
                  {2.2F * size, fork + 1.7F * size},
                  {1.5F * size, fork + 3.1F * size},
                  {0.0F, fork + 3.8F * size}},
                 7);
}

} // namespace aolib::town
