/// Houses with gable or hip roofs, recessed windows and doors, chimneys and dormers.
#include <array>
#include <cmath>
#include <string>

#include <glm/ext/matrix_transform.hpp>
#include <glm/gtc/constants.hpp>

#include "content/generated/TownParts.h"

namespace aolib::town {
namespace {

constexpr float windowDepth = 0.22F;
constexpr float paneGap = 0.02F;
constexpr float storey = 2.9F;

constexpr std::array<glm::vec3, 7> plaster{{{0.80F, 0.73F, 0.60F},
                                            {0.76F, 0.62F, 0.48F},
                                            {0.72F, 0.70F, 0.64F},
                                            {0.79F, 0.67F, 0.55F},
                                            {0.66F, 0.68F, 0.62F},
                                            {0.74F, 0.58F, 0.50F},
                                            {0.62F, 0.66F, 0.70F}}};
constexpr std::array<glm::vec3, 4> tiles{
    {{0.56F, 0.29F, 0.21F}, {0.50F, 0.26F, 0.20F}, {0.60F, 0.35F, 0.25F}, {0.38F, 0.33F, 0.32F}}};

Opening window(float u, float v, float width, float height) {
    return {rectangle({u - 0.5F * width, v}, {u + 0.5F * width, v + height}), windowDepth};
}

/// Windows of one wall in storeys and columns; the first storey may have a door.
std::vector<Opening> facade(float width, int storeys, int columns, int doorColumn, float shift) {
    std::vector<Opening> openings;
    const float pitch = width / static_cast<float>(columns);
    for (int row = 0; row < storeys; ++row) {
        for (int column = 0; column < columns; ++column) {
            const float u = (static_cast<float>(column) + 0.5F) * pitch - 0.5F * width + shift;
            if (row == 0 && column == doorColumn) {
                openings.push_back({rectangle({u - 0.55F, pavement + 0.16F}, {u + 0.55F, 2.45F}),
                                    windowDepth + 0.1F});
            } else {
                const float v = pavement + 1.0F + storey * static_cast<float>(row);
                openings.push_back(window(u, v, row == 0 ? 1.2F : 1.0F, 1.4F));
            }
        }
    }
    return openings;
}

void addChimney(SolidBuilder& builder, float x, float z, float bottom, float top) {
    builder.box({x - 0.4F, bottom, z - 0.35F}, {x + 0.4F, top, z + 0.35F});
}

/// A small gabled window that looks out of the roof towards +z.
void addDormer(SolidBuilder& walls, SolidBuilder& panes, const glm::mat4& place, float x,
               const GableBody& body) {
    const float height = body.eaves + 0.35F * (body.ridge - body.eaves);
    const GableBody dormer{2.2F, 1.5F, height - 1.0F, height + 1.0F, height + 1.55F};
    const glm::mat4 turned =
        glm::rotate(glm::translate(place, {x, 0.0F, 0.36F * body.width - 1.1F}),
                    -glm::half_pi<float>(), {0.0F, 1.0F, 0.0F});
    walls.setPlace(turned);
    panes.setPlace(turned);
    const std::vector<Opening> opening{window(0.0F, height + 0.05F, 0.8F, 0.85F)};
    addGableBody(walls, dormer, {{}, opening, {}, {}});
    addPanes(panes, dormer.wall(Side::Right), opening);
    walls.setPlace(place);
    panes.setPlace(place);
}

} // namespace

Frame GableBody::wall(Side side) const {
    const float x = 0.5F * length;
    const float z = 0.5F * width;
    switch (side) {
    case Side::Front:
        return {{0, 0, z}, {1, 0, 0}, {0, 1, 0}};
    case Side::Right:
        return {{x, 0, 0}, {0, 0, -1}, {0, 1, 0}};
    case Side::Back:
        return {{0, 0, -z}, {-1, 0, 0}, {0, 1, 0}};
    default:
        return {{-x, 0, 0}, {0, 0, 1}, {0, 1, 0}};
    }
}

void addGableBody(SolidBuilder& builder, const GableBody& body,
                  const std::vector<std::vector<Opening>>& openings) {
    const float x = 0.5F * body.length;
    const float z = 0.5F * body.width;
    const Outline eavesWall = rectangle({-x, body.bottom}, {x, body.eaves});
    const Outline gableWall{
        {-z, body.bottom}, {z, body.bottom}, {z, body.eaves}, {0.0F, body.ridge}, {-z, body.eaves}};
    builder.panel(body.wall(Side::Front), eavesWall, openings[0]);
    builder.panel(body.wall(Side::Right), gableWall, openings[1]);
    builder.panel(body.wall(Side::Back), eavesWall, openings[2]);
    builder.panel(body.wall(Side::Left), gableWall, openings[3]);
    builder.quad({-x, body.eaves, z}, {x, body.eaves, z}, {x, body.ridge, 0}, {-x, body.ridge, 0});
    builder.quad({x, body.eaves, -z}, {-x, body.eaves, -z}, {-x, body.ridge, 0},
                 {x, body.ridge, 0});
    builder.quad({-x, body.bottom, -z}, {x, body.bottom, -z}, {x, body.bottom, z},
                 {-x, body.bottom, z});
}

void addGableRoof(SolidBuilder& builder, const GableBody& body, float overhang, float thickness) {
    const float slope = (body.ridge - body.eaves) / (0.5F * body.width);
    const float reach = 0.5F * body.width + overhang;
    const float sunk = 0.06F; // the body's own roof planes lie inside the slab
    const float low = body.ridge - slope * reach - sunk;
    const float high = body.ridge - sunk;
    const Outline chevron{{-reach, low},
                          {0.0F, high},
                          {reach, low},
                          {reach, low + thickness},
                          {0.0F, high + thickness},
                          {-reach, low + thickness}};
    Frame frame = body.wall(Side::Right);
    frame.origin.x += overhang;
    builder.slab(frame, chevron, body.length + 2.0F * overhang);
}

void addPanes(SolidBuilder& builder, const Frame& frame, const std::vector<Opening>& openings) {
    for (const Opening& opening : openings) {
        std::vector<glm::vec3> corners;
        for (const glm::vec2& p : opening.outline) {
            corners.push_back(frame.at(p, opening.depth - paneGap));
        }
        builder.polygon(corners);
    }
}

void addHouse(std::vector<ModelMesh>& meshes, const Plot& plot, int number, Pcg& random) {
    const std::string name = "house " + std::to_string(number);
    const bool gableFront = plot.width < 11.0F && random.pick(3) != 0;
    const int storeys = 2 + (random.pick(8) == 0 ? 1 : 0);
    const float eaves =
        pavement + storey * static_cast<float>(storeys) + random.uniform(0.1F, 0.7F);
    const float length = gableFront ? plot.depth : plot.width;
    const float width = gableFront ? plot.width : plot.depth;
    const GableBody body{length, width, -0.1F, eaves, eaves + width * random.uniform(0.42F, 0.58F)};

    const int columns = plot.width > 12.2F ? 3 : 2;
    std::vector<std::vector<Opening>> openings(4);
    const std::size_t front = gableFront ? 1 : 0;
    openings[front] = facade(plot.width - 1.0F, storeys, columns, random.pick(columns), 0.0F);
    if (random.pick(6) == 0) {
        openings[(front + 2) % 4] = facade(plot.width, 1, 1, -1, random.uniform(-1.5F, 1.5F));
    }
    if (gableFront) {
        openings[1].push_back(window(0.0F, eaves + 0.3F, 0.9F, 1.1F));
    } else if (random.pick(5) == 0) {
        openings[3].push_back(window(0.0F, eaves + 0.2F, 0.8F, 1.1F));
    }

    glm::mat4 place = glm::translate(plot.place, {0.0F, 0.0F, -0.5F * plot.depth});
    const bool withStep = random.pick(2) == 0;
    SolidBuilder walls;
    SolidBuilder panes;
    SolidBuilder roof;
    walls.setPlace(place);
    for (const Opening& opening : openings[front]) {
        if (opening.depth > windowDepth && withStep) { // a step before the door
            const glm::vec2 low = opening.outline[0];
            walls.box({low.x - 0.25F, 0.0F, 0.5F * plot.depth - 0.1F},
                      {low.x + 1.35F, low.y - 0.02F, 0.5F * plot.depth + 0.45F});
        }
    }
    if (gableFront) {
        place = glm::rotate(place, -glm::half_pi<float>(), {0.0F, 1.0F, 0.0F});
    }
    walls.setPlace(place);
    panes.setPlace(place);
    roof.setPlace(place);
    addGableBody(walls, body, openings);
    for (std::size_t side = 0; side < 4; ++side) {
        addPanes(panes, body.wall(static_cast<Side>(side)), openings[side]);
    }
    addGableRoof(roof, body, 0.45F, 0.24F);
    const float chimneyAt = (random.pick(2) == 0 ? -0.3F : 0.3F) * length;
    addChimney(walls, chimneyAt, 0.12F * width, body.eaves, body.ridge + 0.9F);
    if (!gableFront && random.pick(4) == 0) {
        addDormer(walls, panes, place, -0.5F * chimneyAt, body);
    }
    const auto colour = static_cast<std::size_t>(random.pick(static_cast<int>(plaster.size())));
    const auto tile = static_cast<std::size_t>(random.pick(static_cast<int>(tiles.size())));
    meshes.push_back(walls.finish(name + " walls", plaster[colour]));
    meshes.push_back(roof.finish(name + " roof", tiles[tile]));
    meshes.push_back(panes.finish(name + " panes", {0.20F, 0.21F, 0.23F}));
}

} // namespace aolib::town
