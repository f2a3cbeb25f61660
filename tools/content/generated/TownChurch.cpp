/// The church: nave with buttresses and pointed windows, apse, tower with belfry and spire.
#include <glm/ext/matrix_transform.hpp>
#include <glm/gtc/constants.hpp>

#include "content/generated/TownParts.h"

namespace aolib::town {
namespace {

constexpr float frontZ = -28.0F; ///< the tower's front
constexpr float towerHalf = 4.0F;
constexpr float towerTop = 26.0F;
constexpr float plinth = 0.6F;

const GableBody nave{30.0F, 14.0F, 0.0F, 10.0F, 17.0F};

Opening lancet(float u, float sill, float width, float springing, float depth, int segments) {
    return {pointedArch({u - 0.5F * width, sill}, width, springing, segments), depth};
}

std::vector<Opening> naveWindows() {
    std::vector<Opening> openings;
    for (int bay = 0; bay < 5; ++bay) {
        openings.push_back(
            lancet(-11.0F + 5.5F * static_cast<float>(bay), 2.8F, 1.7F, 6.6F, 0.45F, 2));
    }
    return openings;
}

/// The nave's ridge runs north to south.
void addNave(SolidBuilder& walls, SolidBuilder& roof, SolidBuilder& panes) {
    glm::mat4 place =
        glm::translate(glm::mat4(1.0F), {0.0F, 0.0F, frontZ - 2.0F * towerHalf - 15.0F + 1.0F});
    place = glm::rotate(place, glm::half_pi<float>(), {0.0F, 1.0F, 0.0F});
    walls.setPlace(place);
    roof.setPlace(place);
    panes.setPlace(place);
    const std::vector<Opening> windows = naveWindows();
    addGableBody(walls, nave, {windows, {}, windows, {}});
    addPanes(panes, nave.wall(Side::Front), windows);
    addPanes(panes, nave.wall(Side::Back), windows);
    addGableRoof(roof, nave, 0.6F, 0.3F);
    for (int side = -1; side <= 1; side += 2) {
        for (int i = 0; i < 6; ++i) {
            const float x = -13.75F + 5.5F * static_cast<float>(i);
            const auto outward = static_cast<float>(side);
            const Frame frame{{x + 0.4F, 0.0F, 0.0F}, {0, 0, -1}, {0, 1, 0}};
            const float inner = 6.9F;
            Outline buttress{{inner, 0}, {8.3F, 0}, {8.3F, 5.0F}, {7.7F, 6.0F}, {inner, 8.4F}};
            if (outward > 0.0F) { // u runs along -z: the south side has negative u
                for (glm::vec2& p : buttress) {
                    p.x = -p.x;
                }
                buttress = Outline(buttress.rbegin(), buttress.rend());
            }
            walls.slab(frame, buttress, 0.8F);
        }
    }
    // The apse, an eight-sided drum half inside the nave's far end.
    const Outline drum = regularPolygon(5.4F, 8, glm::pi<float>() / 8.0F);
    walls.setPlace(glm::translate(place, {15.0F, 0.0F, 0.0F}));
    walls.prism(drum, 0.0F, 8.0F);
    roof.setPlace(glm::translate(place, {15.0F, 0.0F, 0.0F}));
    roof.lathe({{0.0F, 7.9F}, {6.2F, 7.9F}, {0.0F, 12.5F}}, 8);
}

void addTower(SolidBuilder& walls, SolidBuilder& roof, SolidBuilder& panes) {
    const glm::mat4 place = glm::translate(glm::mat4(1.0F), {0.0F, 0.0F, frontZ - towerHalf});
    const Outline wall = rectangle({-towerHalf, 0.0F}, {towerHalf, towerTop});
    const Opening belfryLeft = lancet(-1.5F, 19.0F, 1.5F, 22.5F, 0.7F, 2);
    const Opening belfryRight = lancet(1.5F, 19.0F, 1.5F, 22.5F, 0.7F, 2);
    for (int side = 0; side < 4; ++side) {
        const glm::mat4 turned =
            glm::rotate(place, glm::half_pi<float>() * static_cast<float>(side), {0, 1, 0});
        walls.setPlace(turned);
        panes.setPlace(turned);
        std::vector<Opening> openings{belfryLeft, belfryRight};
        if (side == 0) {
            openings.push_back(lancet(0.0F, plinth + 0.02F, 2.8F, 3.4F, 0.8F, 4));
            openings.push_back({regularPolygon(1.5F, 12), 0.5F});
            for (glm::vec2& p : openings.back().outline) {
                p.y += 11.0F;
            }
        } else {
            openings.push_back(lancet(0.0F, 12.0F, 0.9F, 14.5F, 0.5F, 2));
        }
        const Frame frame{{0, 0, towerHalf}, {1, 0, 0}, {0, 1, 0}};
        walls.panel(frame, wall, openings);
        addPanes(panes, frame, openings);
    }
    walls.setPlace(place);
    const float t = towerHalf;
    walls.quad({-t, towerTop, t}, {t, towerTop, t}, {t, towerTop, -t}, {-t, towerTop, -t});
    walls.quad({-t, 0, -t}, {t, 0, -t}, {t, 0, t}, {-t, 0, t});
    for (const float height : {9.0F, 17.6F, 25.4F}) { // string courses
        walls.box({-t - 0.25F, height, -t - 0.25F}, {t + 0.25F, height + 0.5F, t + 0.25F});
    }
    roof.setPlace(place);
    roof.frustum({t + 0.45F, t + 0.45F}, {2.0F, 2.0F}, towerTop - 0.1F, towerTop + 3.5F);
    roof.frustum({2.05F, 2.05F}, {0.0F, 0.0F}, towerTop + 3.3F, towerTop + 15.0F);
}

} // namespace

void addChurch(std::vector<ModelMesh>& meshes) {
    SolidBuilder walls;
    SolidBuilder roof;
    SolidBuilder panes;
    SolidBuilder steps;
    addNave(walls, roof, panes);
    addTower(walls, roof, panes);
    for (int i = 0; i < 4; ++i) { // a stepped terrace about the whole church
        const float out = 0.45F * static_cast<float>(3 - i);
        const float top = 0.15F * static_cast<float>(i + 1);
        steps.box({-9.6F - out, -0.1F, -71.0F - out}, {9.6F + out, top, frontZ + 2.6F + out});
    }
    meshes.push_back(walls.finish("church walls", {0.74F, 0.70F, 0.61F}));
    meshes.push_back(roof.finish("church roof", {0.36F, 0.41F, 0.42F}));
    meshes.push_back(panes.finish("church panes", {0.17F, 0.19F, 0.24F}));
    meshes.push_back(steps.finish("church steps", {0.63F, 0.61F, 0.57F}));
}

} // namespace aolib::town
