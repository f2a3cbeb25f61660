/// The rotunda's vault and the lantern upon it.
#include <array>
#include <cmath>

#include <glm/ext/matrix_transform.hpp>
#include <glm/gtc/constants.hpp>

#include "content/generated/DomeParts.h"

namespace aolib::dome {
namespace {

constexpr int sectors = 24;
constexpr float springRadius = 10.4F; ///< of the outer shell
constexpr float pointing = 1.2F;      ///< how far beyond the axis an arc's centre lies
constexpr float eyeRadius = 2.3F;     ///< of the opening under the lantern

float share(int i, int count) {
    return static_cast<float>(i) / static_cast<float>(count);
}

/// The arc's end, where the shell meets the ring under the lantern.
float lastAngle() {
    return std::acos((eyeRadius + pointing) / (springRadius + pointing));
}

/// (radius, height above the springing) at an angle of the arc, `inset` inside the outer shell.
glm::vec2 arc(float angle, float inset) {
    const float r = springRadius + pointing - inset;
    return {r * std::cos(angle) - pointing, r * std::sin(angle)};
}

glm::vec3 onVault(float turn, float angle, float inset, float y) {
    const glm::vec2 p = arc(angle, inset);
    return {p.x * std::sin(turn), y + p.y, p.x * std::cos(turn)};
}

/// Gores that swell between the ribs, closed by a smooth inner side.
void addShell(SolidBuilder& builder, float y) {
    constexpr int rowCount = 26;
    constexpr int perSector = 10;
    std::vector<std::vector<glm::vec3>> rows;
    for (int row = 0; row <= 2 * rowCount + 1; ++row) {
        const bool outer = row <= rowCount;
        const float t = outer ? share(row, rowCount) : share(2 * rowCount + 1 - row, rowCount);
        rows.emplace_back();
        for (int i = 0; i < sectors * perSector; ++i) {
            const float within = share(i % perSector, perSector);
            const float swell = 0.16F * std::sin(glm::pi<float>() * within);
            const float turn = glm::two_pi<float>() * share(i, sectors * perSector);
            rows.back().push_back(onVault(turn, lastAngle() * t, outer ? 0.1F - swell : 0.4F, y));
        }
    }
    builder.surface(rows, true, true);
}

void addRibs(SolidBuilder& builder, float y) {
    constexpr int stations = 32;
    Moulding profile(-0.3F, -0.25F);
    profile.to(0.3F, -0.25F)
        .step(0.0F, 0.36F)
        .cavetto(-0.08F, 0.05F, 3)
        .step(-0.04F, 0.0F)
        .ovolo(-0.06F, 0.1F, 3)
        .to(-0.12F, 0.26F)
        .step(-0.06F, -0.1F)
        .step(-0.04F, 0.0F)
        .to(-0.3F, 0.11F);
    for (int rib = 0; rib < sectors; ++rib) {
        const float turn = glm::two_pi<float>() * share(rib, sectors);
        std::vector<SolidBuilder::Station> path;
        for (int i = 0; i <= stations; ++i) {
            const float angle = lastAngle() * share(i, stations);
            const float narrow = 1.0F - 0.62F * share(i, stations);
            const glm::vec3 side{std::cos(turn), 0.0F, -std::sin(turn)};
            const glm::vec3 out{std::cos(angle) * std::sin(turn), std::sin(angle),
                                std::cos(angle) * std::cos(turn)};
            path.push_back({onVault(turn, angle, 0.0F, y), side * narrow, out * narrow});
        }
        builder.sweep(profile.outline(), path, false);
    }
}

/// One coffer: loops of points that step back towards its middle, seen from below.
void addCoffer(SolidBuilder& builder, float turn0, float turn1, float angle0, float angle1,
               float y) {
    struct Loop {
        float inset; ///< share of the cell
        float depth;
    };
    constexpr int perSide = 3;
    constexpr float surfaceInset = 0.95F;
    constexpr std::array<Loop, 7> loops{{{0.0F, 0.0F},
                                         {0.09F, 0.0F},
                                         {0.10F, 0.14F},
                                         {0.19F, 0.15F},
                                         {0.20F, 0.27F},
                                         {0.29F, 0.28F},
                                         {0.30F, 0.37F}}};
    std::vector<std::vector<glm::vec3>> rows;
    for (const Loop& loop : loops) {
        rows.emplace_back();
        for (int i = 0; i < 4 * perSide; ++i) {
            const float t = share(i % perSide, perSide);
            const int side = i / perSide;
            glm::vec2 p = side == 0   ? glm::vec2(t, 0.0F)
                          : side == 1 ? glm::vec2(1.0F, t)
                          : side == 2 ? glm::vec2(1.0F - t, 1.0F)
                                      : glm::vec2(0.0F, 1.0F - t);
            p = loop.inset + p * (1.0F - 2.0F * loop.inset);
            rows.back().push_back(onVault(glm::mix(turn1, turn0, p.x),
                                          glm::mix(angle0, angle1, p.y), surfaceInset - loop.depth,
                                          y));
        }
    }
    const glm::vec3 middle = onVault(0.5F * (turn0 + turn1), 0.5F * (angle0 + angle1),
                                     surfaceInset - loops.back().depth, y);
    rows.emplace_back(4 * perSide, middle);
    builder.surface(rows, false, true);
    // A rosette in its middle.
    const glm::vec3 inward =
        glm::normalize(onVault(0.5F * (turn0 + turn1), 0.5F * (angle0 + angle1), 2.0F, y) - middle);
    const glm::vec3 side = glm::normalize(glm::cross(glm::vec3(0, 1, 0), inward));
    const glm::mat4 place(glm::vec4(side, 0), glm::vec4(inward, 0),
                          glm::vec4(glm::cross(side, inward), 0), glm::vec4(middle, 1));
    builder.setPlace(place);
    const float size = 0.14F * springRadius * std::cos(angle1) * (turn1 - turn0);
    builder.lathe({{0.0F, -0.01F},
                   {size, -0.01F},
                   {0.9F * size, 0.25F * size},
                   {0.5F * size, 0.2F * size},
                   {0.35F * size, 0.45F * size},
                   {0.0F, 0.55F * size}},
                  9);
    builder.setPlace(glm::mat4(1.0F));
}

void addCoffers(SolidBuilder& builder, float y) {
    constexpr int rowCount = 6;
    constexpr float first = 0.1F;
    constexpr float last = 1.02F;
    for (int row = 0; row < rowCount; ++row) {
        const float angle0 = glm::mix(first, last, std::pow(share(row, rowCount), 0.92F));
        const float angle1 = glm::mix(first, last, std::pow(share(row + 1, rowCount), 0.92F));
        for (int i = 0; i < sectors; ++i) {
            addCoffer(builder, glm::two_pi<float>() * share(i, sectors),
                      glm::two_pi<float>() * share(i + 1, sectors), angle0, angle1, y);
        }
    }
    // Smooth bands below and above the coffers, closed behind.
    for (const glm::vec2& band : {glm::vec2(-0.02F, first), glm::vec2(last, lastAngle() + 0.02F)}) {
        Outline profile;
        constexpr int steps = 6;
        for (int i = 0; i <= steps; ++i) {
            profile.push_back(arc(glm::mix(band.x, band.y, share(i, steps)), 0.45F));
        }
        for (int i = steps; i >= 0; --i) {
            profile.push_back(arc(glm::mix(band.x, band.y, share(i, steps)), 0.95F));
        }
        for (glm::vec2& p : profile) {
            p.y += y;
        }
        builder.lathe(profile, 144, true);
    }
}

} // namespace

void addVault(std::vector<ModelMesh>& meshes, float y) {
    SolidBuilder builder;
    addShell(builder, y);
    meshes.push_back(builder.finish("outer shell", {0.42F, 0.50F, 0.50F}));
    addRibs(builder, y);
    meshes.push_back(builder.finish("ribs", {0.46F, 0.53F, 0.53F}));
    addCoffers(builder, y);
    meshes.push_back(builder.finish("coffers", {0.77F, 0.74F, 0.68F}));
}

void addLantern(std::vector<ModelMesh>& meshes, float y) {
    SolidBuilder builder;
    Moulding ring(1.25F, y - 0.5F); // the ring on which it stands
    ring.to(2.75F, y - 0.5F)
        .step(0.0F, 0.5F)
        .ovolo(0.12F, 0.12F)
        .step(0.0F, 0.1F)
        .cymaReversa(-0.25F, 0.14F)
        .step(0.0F, 0.3F)
        .step(-0.1F, 0.04F)
        .to(1.25F, y + 0.7F);
    builder.lathe(ring.outline(), 72, true);
    const float floor = y + 0.68F;
    constexpr int bays = 12;
    for (int i = 0; i < bays; ++i) {
        builder.setPlace(around(share(i, bays), 0.0F, 0.0F));
        const Frame wall{{0, 0, 1.65F}, {1, 0, 0}, {0, 1, 0}};
        const glm::vec2 low{-0.26F, floor + 0.35F};
        const glm::vec2 high{0.26F, floor + 2.6F};
        builder.slab(wall, rectangle({-0.442F, floor - 0.1F}, {0.442F, floor + 3.1F}), 0.25F,
                     {{roundArch(low, high, 16), 0.0F, true}});
        addArchivolt(builder, wall, low, high, 0.12F);
        builder.setPlace(
            around((static_cast<float>(i) + 0.5F) / static_cast<float>(bays), 2.0F, floor));
        addPlainColumn(builder, 3.0F, 0.16F);
    }
    builder.setPlace(glm::mat4(1.0F));
    builder.lathe(entablature(2.1F, 1.3F, floor + 2.95F, 0.36F), 72, true);
    addCorniceBlocks(builder, 2.1F, floor + 2.95F, 0.36F, 96, 24);
    meshes.push_back(builder.finish("lantern", {0.80F, 0.77F, 0.70F}));

    const float cap = floor + 3.75F;
    Moulding cupola(0.0F, cap);
    cupola.to(2.0F, cap).step(0.0F, 0.15F).cavetto(-0.35F, 0.3F).ovolo(-0.1F, 0.0F, 2);
    for (int i = 1; i <= 14; ++i) {
        const float t = glm::half_pi<float>() * share(i, 14);
        cupola.to(0.28F + 1.27F * std::cos(t), cap + 0.45F + 1.7F * std::sin(t));
    }
    cupola.torus(0.16F, 6).step(-0.08F, 0.05F).cavetto(-0.1F, 0.4F).to(0.1F, cap + 2.85F);
    for (int i = 0; i <= 16; ++i) { // the ball
        const float t = glm::pi<float>() * share(i, 16);
        cupola.to(std::max(0.42F * std::sin(t), i == 16 ? 0.0F : 0.08F),
                  cap + 3.25F - 0.42F * std::cos(t));
    }
    builder.lathe(cupola.outline(), 72);
    builder.box({-0.05F, cap + 3.6F, -0.05F}, {0.05F, cap + 5.1F, 0.05F});
    builder.box({-0.42F, cap + 4.45F, -0.05F}, {0.42F, cap + 4.57F, 0.05F});
    meshes.push_back(builder.finish("cupola", {0.50F, 0.55F, 0.50F}));
}

} // namespace aolib::dome
