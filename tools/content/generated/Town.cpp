/// A small walled town, about 12 thousand triangles on 200 x 200 metres: where everything stands.
#include <array>
#include <cmath>
#include <vector>

#include <glm/ext/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

#include "content/generated/GeneratedScenes.h"
#include "content/generated/TownParts.h"

namespace aolib {
namespace {

/// A raised pavement with a kerb; houses stand on it.
struct Block {
    glm::vec2 low;  ///< x, z
    glm::vec2 high; ///< x, z
};

/// A row of houses: from `start` along `along`, the fronts look to the right of it.
struct Row {
    glm::vec2 start;
    glm::vec2 along;
    float length;
    float depth;
};

constexpr std::array<Block, 10> blocks{{{{-62, 5.5F}, {-23, 37}},
                                        {{-19, 21.5F}, {-5.5F, 37}},
                                        {{-62, 44.5F}, {-5.5F, 64}},
                                        {{23, 5.5F}, {62, 37}},
                                        {{5.5F, 21.5F}, {19, 37}},
                                        {{5.5F, 44.5F}, {62, 64}},
                                        {{-62, -37}, {-23, -5.5F}},
                                        {{-62, -64}, {-18, -44.5F}},
                                        {{42, -37}, {62, -5.5F}},
                                        {{18, -64}, {62, -44.5F}}}};

/// Fronts look to the right of the direction: (along.x, along.z) turned clockwise from above.
constexpr std::array<Row, 18> rows{{
    {{-60.5F, 7.0F}, {1, 0}, 36.0F, 9.5F},   // west street, south side: looks north
    {{-24.5F, 35.5F}, {-1, 0}, 36.0F, 9.5F}, // second street: looks south
    {{-24.5F, 17.5F}, {0, 1}, 8.0F, 9.0F},   // towards the square
    {{-7.0F, 22.5F}, {0, 1}, 13.5F, 10.0F},  // main street, west side
    {{-60.5F, 46.0F}, {1, 0}, 42.0F, 9.5F},
    {{-7.0F, 46.5F}, {0, 1}, 16.0F, 10.0F},
    {{24.5F, 7.0F}, {1, 0}, 36.0F, 9.5F},
    {{60.5F, 35.5F}, {-1, 0}, 36.0F, 9.5F},
    {{7.0F, 36.0F}, {0, -1}, 13.5F, 10.0F}, // main street, east side
    {{18.0F, 46.0F}, {1, 0}, 42.0F, 9.5F},
    {{7.0F, 62.5F}, {0, -1}, 16.0F, 10.0F},
    {{-24.5F, -7.0F}, {-1, 0}, 36.0F, 9.5F}, // west street, north side
    {{-36.5F, -35.5F}, {1, 0}, 12.0F, 9.5F},
    {{-24.5F, -25.0F}, {0, 1}, 8.5F, 9.0F},
    {{-19.5F, -46.0F}, {-1, 0}, 41.0F, 9.5F},
    {{60.5F, -7.0F}, {-1, 0}, 17.0F, 9.5F},
    {{60.5F, -46.0F}, {-1, 0}, 41.0F, 9.5F},
    {{24.5F, 26.0F}, {0, -1}, 8.0F, 9.0F},
}};

void addGround(std::vector<ModelMesh>& meshes) {
    SolidBuilder ground;
    constexpr int cells = 5;
    constexpr float cell = 200.0F / static_cast<float>(cells);
    for (int i = 0; i < cells; ++i) {
        for (int k = 0; k < cells; ++k) {
            const float x = static_cast<float>(i) * cell - 100.0F;
            const float z = static_cast<float>(k) * cell - 100.0F;
            ground.quad({x, 0, z + cell}, {x + cell, 0, z + cell}, {x + cell, 0, z}, {x, 0, z});
        }
    }
    meshes.push_back(ground.finish("ground", {0.55F, 0.52F, 0.46F}));
}

void addBlocks(std::vector<ModelMesh>& meshes) {
    SolidBuilder kerbs;
    SolidBuilder pavements;
    constexpr float kerb = 0.3F;
    for (const Block& block : blocks) {
        // In the plane of the panel v is -z.
        const glm::vec2 low{block.low.x, -block.high.y};
        const glm::vec2 high{block.high.x, -block.low.y};
        const Frame top{{0, town::pavement + 0.02F, 0}, {1, 0, 0}, {0, 0, -1}};
        kerbs.slab(top, rectangle(low, high), town::pavement + 0.1F,
                   {{rectangle(low + kerb, high - kerb), 0.0F, true}});
        pavements.box({block.low.x + 0.5F * kerb, -0.1F, block.low.y + 0.5F * kerb},
                      {block.high.x - 0.5F * kerb, town::pavement, block.high.y - 0.5F * kerb});
    }
    meshes.push_back(kerbs.finish("kerbs", {0.66F, 0.65F, 0.62F}));
    meshes.push_back(pavements.finish("pavements", {0.60F, 0.56F, 0.50F}));
}

void addHouses(std::vector<ModelMesh>& meshes) {
    Pcg random(20240917);
    int number = 0;
    for (const Row& row : rows) {
        float at = 0.0F;
        while (row.length - at > 6.0F) {
            float width = random.uniform(9.6F, 13.4F);
            const float rest = row.length - at - width;
            width = rest < 7.8F ? row.length - at : width;
            if (width > 15.6F) {
                width *= 0.5F;
            }
            // The front looks along (-along.z, along.x) turned outwards: right of the direction.
            const glm::vec2 middle = row.start + row.along * (at + 0.5F * width);
            const glm::vec2 outward{row.along.y, -row.along.x};
            const float setBack = random.uniform(0.0F, 0.5F);
            const glm::vec2 front = middle - outward * setBack;
            glm::mat4 place = glm::translate(glm::mat4(1.0F), {front.x, 0.0F, front.y});
            place = glm::rotate(place, std::atan2(outward.x, outward.y), {0, 1, 0});
            place = glm::rotate(place, glm::radians(random.uniform(-0.8F, 0.8F)), {0, 1, 0});
            town::addHouse(meshes, {place, width - 0.25F, row.depth + random.uniform(-0.8F, 0.8F)},
                           ++number, random);
            at += width;
        }
    }
}

void addTrees(std::vector<ModelMesh>& meshes) {
    Pcg random(77);
    SolidBuilder trunks;
    SolidBuilder crowns;
    constexpr std::array<glm::vec3, 20> places{
        {{16.5F, 4.5F, 0}, {15.5F, 17.0F, 0}, {-30, -21.0F, 0}, {-45, 21.5F, 0}, {-52, 22, 0},
         {-36, 21, 0},     {48, 21.5F, 0},    {38, 22, 0},      {-45, -21, 0},   {-52, -20.5F, 0},
         {-36, -21.5F, 0}, {52, -21, 0},      {-15, -48, 1},    {-15, -56, 1},   {15, -48, 1},
         {15, -56, 1},     {-9, 92, 0},       {12, 94, 0},      {35, 92, 0},     {92, 30, 0}}};
    for (const glm::vec3& place : places) {
        town::addTree(trunks, crowns, {place.x, place.y}, place.z > 0.5F, random);
    }
    meshes.push_back(trunks.finish("tree trunks", {0.36F, 0.29F, 0.22F}));
    meshes.push_back(crowns.finish("tree crowns", {0.35F, 0.44F, 0.26F}));
}

} // namespace

Model buildTown() {
    Model model{"town", {}};
    addGround(model.meshes);
    addBlocks(model.meshes);
    addHouses(model.meshes);
    town::addChurch(model.meshes);
    town::addTownHall(model.meshes);
    town::addSquare(model.meshes);
    town::addCityWall(model.meshes);
    addTrees(model.meshes);
    return model;
}

std::vector<NamedCamera> townCameras() {
    return {
        {"square", {-19.5F, 3.4F, 19.2F}, {5.0F, 5.6F, -22.0F}, {0, 1, 0}, 60.0F, 0.2F, 320.0F},
        {"street", {1.2F, 1.7F, 60.0F}, {-0.6F, 4.0F, 20.0F}, {0, 1, 0}, 55.0F, 0.1F, 320.0F},
        {"aerial", {88.0F, 66.0F, 118.0F}, {2.0F, 0.0F, 2.0F}, {0, 1, 0}, 40.0F, 1.0F, 500.0F},
        {"arcade", {26.4F, 2.0F, -9.4F}, {25.6F, 2.2F, -28.0F}, {0, 1, 0}, 60.0F, 0.05F, 320.0F}};
}

std::vector<glm::vec3> townWalk() {
    constexpr float eye = 1.7F;
    return {{0.0F, eye, 94.0F},   {0.0F, eye, 70.0F},   {0.5F, eye, 41.0F},   {0.0F, eye, 22.0F},
            {-9.5F, eye, 8.0F},   {-10.0F, eye, -3.0F}, {-5.0F, eye, -14.0F}, {6.0F, eye, -16.0F},
            {15.0F, eye, -10.0F}, {15.0F, eye, 0.0F},   {40.0F, eye, 0.5F},   {68.0F, eye, 0.0F},
            {68.0F, eye, 40.5F},  {30.0F, eye, 41.0F},  {0.0F, eye, 41.0F},   {-66.0F, eye, 40.5F},
            {-67.0F, eye, 0.0F},  {-40.0F, eye, 0.0F},  {-19.0F, eye, 0.0F}};
}

} // namespace aolib
