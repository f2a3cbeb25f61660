/// The rotunda's columns: Attic bases, fluted shafts, leafy capitals.
#include <algorithm>
#include <cmath>

#include <glm/gtc/constants.hpp>

#include "content/generated/DomeParts.h"

namespace aolib::dome {
namespace {

constexpr float quarter = glm::half_pi<float>();

float share(int i, int count) {
    return static_cast<float>(i) / static_cast<float>(count);
}

/// The attic base: plinth, torus, scotia, torus. In units of the radius.
void addBase(SolidBuilder& builder, float r, int segments) {
    builder.box({-1.4F * r, 0.0F, -1.4F * r}, {1.4F * r, 0.28F * r, 1.4F * r});
    Moulding profile(0.0F, 0.27F * r);
    profile.to(1.28F * r, 0.27F * r)
        .torus(0.32F * r, 6)
        .step(-0.06F * r, 0.0F)
        .step(0.0F, 0.04F * r)
        .cavetto(-0.1F * r, 0.12F * r, 3)
        .ovolo(0.04F * r, 0.08F * r, 2)
        .step(0.0F, 0.04F * r)
        .torus(0.2F * r, 5)
        .step(0.0F, 0.05F * r)
        .to(0.0F, 1.12F * r);
    builder.lathe(profile.outline(), segments);
}

/// One leaf of a capital: a strip that rises and curls outwards.
void addLeaf(SolidBuilder& builder, float r, float bottom, float top, float width, float angle,
             int stations) {
    std::vector<SolidBuilder::Station> path;
    const glm::vec3 side{-std::sin(angle), 0.0F, -std::cos(angle)};
    const glm::vec3 outward{std::cos(angle), 0.0F, -std::sin(angle)};
    const glm::vec3 up{0.0F, 1.0F, 0.0F};
    for (int i = 0; i <= stations; ++i) {
        const float t = share(i, stations);
        const float curl = std::max(0.0F, t - 0.55F) / 0.45F;
        const float rise = std::min(t / 0.8F, 1.0F) - 0.18F * curl * curl;
        const float lean = 0.06F * t + 0.28F * curl * curl;
        const float taper = std::sqrt(std::max(0.05F, 1.0F - t * t));
        const glm::vec3 centre =
            outward * (r * (0.9F + lean)) + up * (bottom + (top - bottom) * rise);
        const float turn = 1.9F * curl;
        const glm::vec3 out = outward * std::cos(turn) - up * std::sin(turn);
        path.push_back({centre, side * (width * taper), out * (0.09F * r)});
    }
    builder.sweep({{-1.0F, -0.3F},
                   {0.0F, -0.5F},
                   {1.0F, -0.3F},
                   {0.35F, 0.35F},
                   {0.0F, 1.0F},
                   {-0.35F, 0.35F}},
                  path, false);
}

void addVolute(SolidBuilder& builder, float r, float top, float angle, int stations) {
    std::vector<SolidBuilder::Station> path;
    const glm::vec3 side{-std::sin(angle), 0.0F, -std::cos(angle)};
    const glm::vec3 outward{std::cos(angle), 0.0F, -std::sin(angle)};
    const glm::vec3 up{0.0F, 1.0F, 0.0F};
    const glm::vec3 middle = outward * (1.25F * r) + up * (top - 0.3F * r);
    for (int i = 0; i <= stations; ++i) {
        const float t = share(i, stations);
        const float turn = glm::pi<float>() * (1.15F - 3.3F * t);
        const float reach = r * (0.42F - 0.36F * std::sqrt(t));
        const glm::vec3 radial = outward * std::cos(turn) + up * std::sin(turn);
        path.push_back({middle + radial * reach, side * (0.12F * r * (1.1F - 0.5F * t)),
                        radial * (0.06F * r)});
    }
    builder.sweep({{-1, -1}, {1, -1}, {1, 1}, {0.5F, 0.6F}, {-0.5F, 0.6F}, {-1, 1}}, path, false);
}

void addCapital(SolidBuilder& builder, float r, float bottom, float top,
                const ColumnDetail& detail) {
    const float height = top - bottom;
    Moulding bell(0.0F, bottom);
    bell.to(0.9F * r, bottom)
        .torus(0.16F * r, 5)
        .step(-0.04F * r, 0.02F * r)
        .step(0.0F, 0.5F * height)
        .cavetto(0.28F * r, 0.25F * height, 4)
        .step(0.06F * r, 0.05F * r)
        .to(0.0F, top - 0.17F * r);
    builder.lathe(bell.outline(), detail.bellSegments);
    for (int i = 0; i < 8; ++i) {
        const float angle = glm::two_pi<float>() * share(i, 8);
        addLeaf(builder, r, bottom + 0.16F * r, bottom + 0.5F * height, 0.3F * r, angle,
                detail.leafStations);
        addLeaf(builder, r, bottom + 0.3F * r, bottom + 0.78F * height, 0.26F * r,
                angle + glm::pi<float>() / 8.0F, detail.leafStations);
    }
    for (int i = 0; i < 4; ++i) {
        addVolute(builder, r, top, quarter * (0.5F + static_cast<float>(i)), detail.voluteStations);
    }
    Outline abacus; // sides that curve inwards
    for (int side = 0; side < 4; ++side) {
        for (int i = 0; i < 5; ++i) {
            const float t = share(i, 5);
            const float angle = quarter * (static_cast<float>(side) + 0.5F + t);
            const float reach = r * (1.62F - 0.5F * std::sin(glm::pi<float>() * t));
            abacus.emplace_back(reach * std::cos(angle), reach * std::sin(angle));
        }
    }
    builder.prism(abacus, top - 0.18F * r, top);
}

} // namespace

void addFlutedColumn(SolidBuilder& builder, float height, float radius,
                     const ColumnDetail& detail) {
    constexpr int flutes = 24;
    const int perFlute = detail.perFlute;
    const int rowCount = detail.shaftRows;
    const auto around = static_cast<std::size_t>(flutes * perFlute);
    const float bottom = 1.1F * radius;
    const float top = height - 2.3F * radius;
    addBase(builder, radius, detail.baseSegments);
    std::vector<std::vector<glm::vec3>> rows(1, std::vector<glm::vec3>(around));
    for (glm::vec3& p : rows.front()) {
        p = {0.0F, bottom, 0.0F};
    }
    for (int row = 0; row <= rowCount; ++row) {
        // The first and last rows are round; the flutes end just above and below them.
        const float t = row == 0          ? 0.0F
                        : row == rowCount ? 1.0F
                                          : 0.04F + 0.93F * share(row - 1, rowCount - 2);
        const float depth = row == 0 || row == rowCount ? 0.0F : 0.075F;
        const float entasis = radius * (1.0F - 0.15F * t * t);
        rows.emplace_back();
        for (int i = 0; i < flutes * perFlute; ++i) {
            const float within = share(i % perFlute, perFlute);
            const float hollow = within < 0.16F ? 0.0F : (within - 0.16F) / 0.84F;
            const float r = entasis * (1.0F - depth * std::sin(glm::pi<float>() * hollow));
            const float angle = glm::two_pi<float>() * share(i, flutes * perFlute);
            rows.back().emplace_back(r * std::cos(angle), bottom + (top - bottom) * t,
                                     -r * std::sin(angle));
        }
    }
    rows.emplace_back(around, glm::vec3(0.0F, top, 0.0F));
    builder.surface(rows, false, true);
    addCapital(builder, radius * 0.92F, top - 0.01F, height, detail);
}

void addPlainColumn(SolidBuilder& builder, float height, float radius) {
    addBase(builder, radius, 16);
    const float top = height - 0.9F * radius;
    Moulding shaft(0.0F, 1.1F * radius);
    shaft.to(radius, 1.1F * radius)
        .step(-0.03F * radius, 0.5F * (top - 1.1F * radius))
        .to(0.86F * radius, top)
        .torus(0.16F * radius, 6)
        .step(0.0F, 0.2F * radius)
        .ovolo(0.3F * radius, 0.3F * radius, 3)
        .to(0.0F, height - 0.24F * radius);
    builder.lathe(shaft.outline(), 18);
    builder.box({-1.3F * radius, height - 0.26F * radius, -1.3F * radius},
                {1.3F * radius, height, 1.3F * radius});
}

} // namespace aolib::dome
