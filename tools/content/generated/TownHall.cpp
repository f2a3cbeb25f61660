/// The town hall: an upper storey over an open arcade with pillars, facing the square.
#include <glm/ext/matrix_transform.hpp>
#include <glm/gtc/constants.hpp>

#include "content/generated/TownParts.h"

namespace aolib::town {
namespace {

constexpr int bays = 6;
constexpr float bay = 4.2F;
constexpr float length = bay * static_cast<float>(bays);
constexpr float depth = 13.0F;
constexpr float loggia = 4.5F; ///< depth of the arcade
constexpr float arcadeTop = 5.6F;
constexpr float platform = 0.3F;

/// The wall of arches along the front; pillars stand before its piers.
void addArcade(SolidBuilder& walls) {
    const Frame frame{{0, 0, 0.5F * depth}, {1, 0, 0}, {0, 1, 0}};
    std::vector<Opening> arches;
    for (int i = 0; i < bays; ++i) {
        const float u = (static_cast<float>(i) + 0.5F) * bay - 0.5F * length;
        arches.push_back({roundArch({u - 1.55F, platform - 0.05F}, {u + 1.55F, 4.7F}, 6), 0, true});
    }
    walls.slab(frame, rectangle({-0.5F * length, 0.0F}, {0.5F * length, arcadeTop}), 0.7F, arches);
    const Opening side{roundArch({-1.3F, platform - 0.05F}, {1.3F, 4.5F}, 6), 0, true};
    const float middle = 0.5F * depth - 0.5F * loggia;
    const Outline end = rectangle({-0.5F * loggia + 0.6F, 0.0F}, {0.5F * loggia, arcadeTop});
    walls.slab({{0.5F * length - 0.02F, 0, middle - 0.1F}, {0, 0, -1}, {0, 1, 0}}, end, 0.6F,
               {side});
    for (int i = 0; i <= bays; ++i) {
        const float x = static_cast<float>(i) * bay - 0.5F * length;
        const float z = 0.5F * depth + 0.25F;
        const glm::mat4 back = walls.place();
        walls.setPlace(glm::translate(back, {x, 0.0F, z}));
        walls.prism(regularPolygon(0.34F, 8, glm::pi<float>() / 8.0F), platform + 0.4F, 4.6F);
        walls.box({-0.45F, platform - 0.1F, -0.45F}, {0.45F, platform + 0.45F, 0.45F});
        walls.box({-0.45F, 4.5F, -0.45F}, {0.45F, 4.85F, 0.45F});
        walls.setPlace(back);
    }
}

} // namespace

void addTownHall(std::vector<ModelMesh>& meshes) {
    glm::mat4 place = glm::translate(glm::mat4(1.0F), {24.0F + 0.5F * depth, 0.0F, -20.0F});
    place = glm::rotate(place, -glm::half_pi<float>(), {0, 1, 0}); // the front looks west
    SolidBuilder walls;
    SolidBuilder roof;
    SolidBuilder panes;
    SolidBuilder steps;
    walls.setPlace(place);
    roof.setPlace(place);
    panes.setPlace(place);
    steps.setPlace(place);
    addArcade(walls);

    // The closed ground storey behind the arcade.
    const GableBody upper{length, depth, arcadeTop - 0.05F, 10.4F, 14.8F};
    const float backZ = 0.5F * depth - loggia;
    const Frame inner{{0, 0, backZ}, {1, 0, 0}, {0, 1, 0}};
    std::vector<Opening> doors;
    for (int i = 0; i < bays; i += 2) {
        const float u = (static_cast<float>(i) + 1.0F) * bay - 0.5F * length;
        doors.push_back({roundArch({u - 0.8F, platform + 0.05F}, {u + 0.8F, 3.4F}, 4), 0.4F});
    }
    const float half = 0.5F * length - 0.05F;
    walls.slab(inner, rectangle({-half, 0.0F}, {half, arcadeTop}), backZ + 0.5F * depth, doors);
    addPanes(panes, inner, doors);

    std::vector<Opening> windows;
    for (int i = 0; i < bays; ++i) {
        const float u = (static_cast<float>(i) + 0.5F) * bay - 0.5F * length;
        windows.push_back({rectangle({u - 0.75F, 6.6F}, {u + 0.75F, 9.2F}), 0.3F});
    }
    addGableBody(walls, upper, {windows, {}, {windows[1], windows[4]}, {}});
    addPanes(panes, upper.wall(Side::Front), windows);
    addPanes(panes, upper.wall(Side::Back), {windows[1], windows[4]});
    walls.box({-0.5F * length - 0.2F, arcadeTop - 0.2F, -0.5F * depth - 0.2F},
              {0.5F * length + 0.2F, arcadeTop + 0.2F, 0.5F * depth + 0.2F});
    addGableRoof(roof, upper, 0.6F, 0.28F);
    roof.box({-1.2F, 14.0F, -1.2F}, {1.2F, 17.0F, 1.2F}); // the bell turret
    roof.frustum({1.6F, 1.6F}, {0.0F, 0.0F}, 16.9F, 20.0F);
    for (int i = 0; i < 2; ++i) {
        const float out = 0.5F * static_cast<float>(1 - i);
        steps.box({-0.5F * length - 0.8F - out, -0.1F, -0.5F * depth + 0.1F},
                  {0.5F * length + 0.8F + out, 0.15F * static_cast<float>(i + 1),
                   0.5F * depth + 1.2F + out});
    }
    meshes.push_back(walls.finish("town hall walls", {0.78F, 0.66F, 0.50F}));
    meshes.push_back(roof.finish("town hall roof", {0.44F, 0.27F, 0.22F}));
    meshes.push_back(panes.finish("town hall panes", {0.19F, 0.18F, 0.18F}));
    meshes.push_back(steps.finish("town hall steps", {0.63F, 0.61F, 0.57F}));
}

} // namespace aolib::town
