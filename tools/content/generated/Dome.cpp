/// A domed rotunda with real, fine detail, about 564 thousand triangles: a ring of fluted columns,
/// a drum with arched windows, a ribbed dome with coffers inside, and a lantern.
#include <cmath>

#include <glm/ext/matrix_transform.hpp>
#include <glm/gtc/constants.hpp>

#include "content/generated/DomeParts.h"
#include "content/generated/GeneratedScenes.h"

namespace aolib {
namespace {

using dome::around;

constexpr int bays = 24;
constexpr int roundSegments = 144;
constexpr float floorY = 1.5F;
constexpr float columnHeight = 9.0F;
constexpr float columnRing = 14.6F;
constexpr float orderTop = floorY + columnHeight; ///< the underside of the lower entablature
constexpr float terrace = 12.75F;
constexpr float wallOuter = 11.0F;
constexpr float wallThickness = 1.0F;
constexpr float drumOrder = 13.9F; ///< where the drum's columns stand
constexpr float drumTop = 19.3F;
constexpr float springing = 22.2F;
constexpr float lanternY = 33.1F;

float bayShare(int i, float offset = 0.0F) {
    return (static_cast<float>(i) + offset) / static_cast<float>(bays);
}

void addBase(std::vector<ModelMesh>& meshes) {
    SolidBuilder builder;
    builder.quad({-60, 0, 60}, {60, 0, 60}, {60, 0, -60}, {-60, 0, -60});
    meshes.push_back(builder.finish("ground", {0.60F, 0.58F, 0.53F}));
    dome::Moulding steps(0.0F, -0.2F);
    steps.to(19.2F, -0.2F).step(0.0F, 0.2F);
    for (int i = 0; i < 5; ++i) {
        steps.step(0.0F, 0.24F).step(0.04F, 0.02F).step(0.0F, 0.04F).step(-0.56F, 0.0F);
    }
    steps.to(0.0F, floorY);
    builder.lathe(steps.outline(), roundSegments);
    meshes.push_back(builder.finish("steps", {0.70F, 0.68F, 0.63F}));
}

/// The wall of the cella and, above the terrace, the drum: one closed slab for each bay.
void addWalls(std::vector<ModelMesh>& meshes) {
    SolidBuilder walls;
    SolidBuilder frames;
    const float half = wallOuter * std::tan(glm::pi<float>() / static_cast<float>(bays));
    const glm::vec2 windowLow{-0.72F, drumOrder + 0.5F};
    const glm::vec2 windowHigh{0.72F, drumTop - 0.75F};
    for (int i = 0; i < bays; ++i) {
        const glm::mat4 place = around(bayShare(i), 0.0F, 0.0F);
        walls.setPlace(place);
        frames.setPlace(place);
        const Frame outside{{0, 0, wallOuter}, {1, 0, 0}, {0, 1, 0}};
        const Frame inside{{0, 0, wallOuter - wallThickness}, {-1, 0, 0}, {0, 1, 0}};
        const bool door = i % 6 == 0;
        const glm::vec2 low{-0.85F, door ? floorY + 0.02F : floorY + 1.2F};
        const glm::vec2 high{0.85F, door ? 7.2F : 6.6F};
        walls.slab(outside, rectangle({-half, floorY - 0.2F}, {half, drumTop + 0.3F}),
                   wallThickness,
                   {{roundArch(windowLow, windowHigh, 28), 0.0F, true},
                    {roundArch(low, high, 28), 0.45F, door}});
        dome::addArchivolt(frames, outside, windowLow, windowHigh, 0.3F);
        dome::addArchivolt(frames, outside, low, high, 0.3F);
        dome::addArchivolt(frames, inside, windowLow, windowHigh, 0.26F);
        dome::addArchivolt(frames, inside, {-0.85F, floorY + 0.02F}, {0.85F, 7.2F}, 0.26F);
        frames.box({-1.0F, windowLow.y - 0.22F, wallOuter - 0.1F},
                   {1.0F, windowLow.y, wallOuter + 0.22F});
        frames.box({-0.14F, windowHigh.y - 0.1F, wallOuter - 0.1F}, // the keystone
                   {0.14F, windowHigh.y + 0.42F, wallOuter + 0.2F});
    }
    meshes.push_back(walls.finish("walls", {0.79F, 0.74F, 0.64F}));
    meshes.push_back(frames.finish("window frames", {0.82F, 0.79F, 0.72F}));
}

void addOrders(std::vector<ModelMesh>& meshes) {
    SolidBuilder columns;
    SolidBuilder drum;
    SolidBuilder inner;
    for (int i = 0; i < bays; ++i) {
        columns.setPlace(around(bayShare(i, 0.5F), columnRing, floorY));
        dome::addFlutedColumn(columns, columnHeight, 0.52F, {5, 7, 28, 24, 4, 12});
        drum.setPlace(around(bayShare(i, 0.5F), wallOuter + 0.28F, drumOrder));
        dome::addFlutedColumn(drum, drumTop - drumOrder, 0.33F, {4, 5, 20, 16, 3, 8});
        drum.box({-0.5F, terrace - drumOrder - 0.1F, -0.7F}, {0.5F, 0.02F, 0.5F});
        inner.setPlace(around(bayShare(i, 0.5F), wallOuter - wallThickness + 0.1F, 0.0F));
        inner.box({-0.3F, floorY - 0.1F, -0.32F}, {0.3F, floorY + 0.5F, 0.2F});
        inner.box({-0.25F, floorY + 0.4F, -0.25F}, {0.25F, 10.2F, 0.2F});
        inner.box({-0.31F, 10.1F, -0.33F}, {0.31F, 10.6F, 0.2F});
        inner.box({-0.22F, 12.3F, -0.22F}, {0.22F, drumTop + 0.1F, 0.2F});
    }
    meshes.push_back(columns.finish("columns", {0.83F, 0.80F, 0.73F}));
    meshes.push_back(drum.finish("drum columns", {0.83F, 0.80F, 0.73F}));
    meshes.push_back(inner.finish("pilasters", {0.80F, 0.76F, 0.68F}));
}

void addRings(std::vector<ModelMesh>& meshes) {
    SolidBuilder builder;
    constexpr float lowerScale = 0.93F;
    builder.lathe(
        dome::entablature(columnRing + 0.42F, columnRing - 0.5F, orderTop - 0.01F, lowerScale),
        roundSegments, true);
    dome::addCorniceBlocks(builder, columnRing + 0.42F, orderTop - 0.01F, lowerScale, 264, 72);
    // The terrace over the ambulatory, with a beam over each column.
    builder.lathe({{wallOuter - 0.5F, 12.2F},
                   {columnRing, 12.2F},
                   {columnRing, terrace - 0.05F},
                   {columnRing - 0.2F, terrace},
                   {wallOuter - 0.5F, terrace}},
                  roundSegments, true);
    dome::Moulding string(wallOuter - 0.3F, 8.35F); // a string course over the niches
    string.to(wallOuter + 0.02F, 8.35F)
        .step(0.1F, 0.04F)
        .step(0.0F, 0.16F)
        .cymaRecta(0.14F, 0.14F)
        .step(0.0F, 0.06F)
        .to(wallOuter - 0.3F, 8.85F);
    builder.lathe(string.outline(), roundSegments, true);
    for (int i = 0; i < bays; ++i) {
        builder.setPlace(around(bayShare(i, 0.5F), 0.0F, 0.0F));
        builder.box({-0.35F, orderTop + 0.6F, wallOuter - 0.3F}, {0.35F, 12.3F, columnRing - 0.3F});
    }
    builder.setPlace(glm::mat4(1.0F));
    constexpr float upperScale = 0.66F;
    builder.lathe(
        dome::entablature(wallOuter + 0.62F, wallOuter - 0.9F, drumTop - 0.01F, upperScale),
        roundSegments, true);
    dome::addCorniceBlocks(builder, wallOuter + 0.62F, drumTop - 0.01F, upperScale, 264, 72);
    dome::Moulding attic(9.4F, 20.6F);
    attic.to(11.3F, 20.6F)
        .step(0.0F, 0.4F)
        .cymaReversa(-0.2F, 0.15F)
        .step(0.0F, 0.75F)
        .ovolo(0.15F, 0.12F)
        .step(0.0F, 0.12F)
        .cymaReversa(-0.5F, 0.2F)
        .to(9.4F, springing + 0.1F);
    builder.lathe(attic.outline(), roundSegments, true);
    meshes.push_back(builder.finish("entablatures", {0.81F, 0.77F, 0.69F}));

    // Inside, a cornice over each storey; they are seen from the axis, so their profile looks back.
    for (const float y : {10.55F, 19.9F}) {
        dome::Moulding cornice(10.2F, y + 1.75F);
        cornice.step(-1.1F, 0.0F)
            .step(0.0F, -0.1F)
            .cymaRecta(0.2F, -0.24F)
            .step(0.0F, -0.16F)
            .step(0.3F, -0.02F)
            .ovolo(0.12F, -0.14F)
            .step(0.0F, -0.5F)
            .step(-0.06F, -0.06F)
            .step(0.0F, -0.2F)
            .to(10.2F, y + 0.25F);
        builder.lathe(cornice.outline(), roundSegments, true);
    }
    meshes.push_back(builder.finish("inner cornices", {0.80F, 0.76F, 0.68F}));
}

void addBalustrade(std::vector<ModelMesh>& meshes) {
    SolidBuilder builder;
    constexpr float ring = columnRing + 0.2F;
    constexpr int balusters = 6;
    const auto rail = [&](float low, float high, float halfWidth) {
        dome::Moulding profile(ring - halfWidth, low);
        profile.to(ring + halfWidth, low)
            .step(0.03F, 0.02F)
            .torus(high - low - 0.04F, 6)
            .to(ring - halfWidth, high);
        builder.lathe(profile.outline(), roundSegments, true);
    };
    rail(terrace - 0.1F, terrace + 0.12F, 0.16F);
    rail(terrace + 0.95F, terrace + 1.1F, 0.15F);
    for (int i = 0; i < bays; ++i) {
        builder.setPlace(around(bayShare(i, 0.5F), ring, terrace));
        builder.box({-0.3F, -0.1F, -0.27F}, {0.3F, 1.14F, 0.27F});
        builder.box({-0.36F, 1.12F, -0.33F}, {0.36F, 1.24F, 0.33F});
        builder.setPlace(around(bayShare(i, 0.5F), ring, terrace + 1.22F));
        dome::addUrn(builder, 1.0F);
        for (int k = 0; k < balusters; ++k) {
            const float offset =
                0.5F + (static_cast<float>(k) + 1.0F) / static_cast<float>(balusters + 1);
            builder.setPlace(around(bayShare(i, offset), ring, terrace + 0.1F));
            dome::addBaluster(builder, 0.87F);
        }
    }
    meshes.push_back(builder.finish("balustrade", {0.82F, 0.79F, 0.72F}));
}

} // namespace

Model buildDome() {
    Model model{"dome", {}};
    addBase(model.meshes);
    addWalls(model.meshes);
    addOrders(model.meshes);
    addRings(model.meshes);
    addBalustrade(model.meshes);
    dome::addVault(model.meshes, springing);
    dome::addLantern(model.meshes, lanternY);
    return model;
}

std::vector<NamedCamera> domeCameras() {
    return {
        {"outside", {25.0F, 8.0F, 44.0F}, {0.0F, 19.0F, 0.0F}, {0, 1, 0}, 52.0F, 0.5F, 300.0F},
        {"inside", {0.6F, 3.2F, 8.4F}, {0.0F, 14.0F, -4.0F}, {0, 1, 0}, 75.0F, 0.1F, 150.0F},
        {"terrace", {9.2F, 14.6F, 10.2F}, {4.0F, 16.0F, 10.9F}, {0, 1, 0}, 60.0F, 0.05F, 200.0F},
        {"peristyle", {10.6F, 3.3F, 18.5F}, {0.0F, 6.8F, 12.6F}, {0, 1, 0}, 60.0F, 0.1F, 200.0F}};
}

} // namespace aolib
