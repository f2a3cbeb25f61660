#include <aolib/lighting/SectorTable.h>

#include <cmath>
#include <set>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include "TestSkies.h"

namespace aolib::lighting::test {
namespace {

SectorTable sectorTableOf(const EnvironmentMap& map) {
    Result<SectorTable> table = SectorTable::create(map);
    EXPECT_TRUE(table.ok()) << table.status().message();
    return *table;
}

OpenSectors openSectors(float share = 1.0F) {
    OpenSectors open;
    open.fill(share);
    return open;
}

TEST(SectorTableTest, SectorsAreQuartersOfACubesFaces) {
    EXPECT_EQ(sectorOfDirection({2.0F, 1.0F, 1.0F}), 7);
    EXPECT_EQ(sectorOfDirection({2.0F, -1.0F, 1.0F}), 5);
    EXPECT_EQ(sectorOfDirection({-2.0F, 1.0F, 1.0F}), 6);
    EXPECT_EQ(sectorOfDirection({1.0F, 2.0F, -1.0F}), 8 + 3);
    EXPECT_EQ(sectorOfDirection({1.0F, 1.0F, 2.0F}), 16 + 7);
    std::set<int> found;
    for (int i = 0; i < 400; ++i) {
        const float height = (float(i) + 0.5F) / 200.0F - 1.0F;
        const float across = std::sqrt(1.0F - height * height);
        const float turn = 2.4F * float(i);
        found.insert(sectorOfDirection({across * std::cos(turn), height, across * std::sin(turn)}));
    }
    EXPECT_EQ(found.size(), 24U);
    EXPECT_EQ(*found.begin(), 0);
    EXPECT_EQ(*found.rbegin(), 23);
}

TEST(SectorTableTest, AnOpenSurfaceHasTheIrradianceOfAnUpperSky) {
    // (1 + cos t) / 2 at the angle t to its pole. Bounds: rows of texels, and between the table's
    // 17 rows, where a horizon has an edge.
    const SectorTable table = sectorTableOf(upperSky());
    for (float degrees = 3.0F; degrees < 180.0F; degrees += 11.0F) {
        const float t = glm::radians(degrees);
        const glm::vec3 normal(std::sin(t) * 0.6F, std::cos(t), std::sin(t) * 0.8F);
        EXPECT_NEAR(sectorLight(table, normal, openSectors()).r, 0.5F * (1.0F + std::cos(t)), 0.01F)
            << degrees;
        EXPECT_NEAR(sectorLight(table, normal, openSectors(0.25F)).r,
                    0.25F * sectorLight(table, normal, openSectors()).r, 1e-5F);
        EXPECT_EQ(sectorLight(table, normal, openSectors(-1.0F)), glm::vec3(0.0F)) << "cut";
    }
}

TEST(SectorTableTest, LightComesFromOpenSectorsAlone) {
    // One bright spot about a direction well within a sector.
    const glm::vec3 spot = glm::normalize(glm::vec3(1.0F, 0.5F, 0.4F));
    const auto sky = mapOf(256, 128, [&](const glm::vec3& direction) {
        return glm::vec3(glm::dot(direction, spot) > 0.99F ? 1.0F : 0.0F);
    });
    const SectorTable table = sectorTableOf(sky);
    const glm::vec3 normal = glm::normalize(glm::vec3(0.5F, 1.0F, 0.2F));
    OpenSectors open = openSectors(0.0F);
    open[static_cast<std::size_t>(sectorOfDirection(spot))] = 1.0F;
    // A cap of height 0.01: its solid angle over pi is 0.02.
    EXPECT_NEAR(sectorLight(table, normal, open).g, 0.02F * glm::dot(normal, spot), 0.0008F);
    OpenSectors others = openSectors();
    others[static_cast<std::size_t>(sectorOfDirection(spot))] = 0.0F;
    EXPECT_EQ(sectorLight(table, normal, others), glm::vec3(0.0F));
    EXPECT_EQ(sectorLight(table, -spot, openSectors()), glm::vec3(0.0F)) << "behind the surface";
}

TEST(SectorTableTest, EveryMisuseHasItsCode) {
    EXPECT_EQ(SectorTable::create(upperSky(), {.columns = 3}).status().code(),
              StatusCode::InvalidOption);
    EXPECT_EQ(SectorTable::create(upperSky(), {.rows = 257}).status().code(),
              StatusCode::InvalidOption);
    EXPECT_EQ(SectorTable::create({}).status().code(), StatusCode::InvalidOption);
}

} // namespace
} // namespace aolib::lighting::test
