#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <aolib/lighting/EnvironmentMap.h>

#include "TestSkies.h"

namespace aolib::lighting::test {
namespace {

TEST(EnvironmentMapTest, AxesLieWhereTheHeaderSays) {
    EXPECT_NEAR(latLong({1, 0, 0}).x, 0.5F, 1e-6F);
    EXPECT_NEAR(latLong({0, 0, 1}).x, 0.75F, 1e-6F);
    EXPECT_NEAR(latLong({0, 0, -1}).x, 0.25F, 1e-6F);
    EXPECT_NEAR(latLong({0, 5, 0}).y, 1.0F, 1e-6F);
    EXPECT_NEAR(latLong({0, -0.1F, 0}).y, 0.0F, 1e-6F);
    EXPECT_NEAR(latLong({3, 0, 4}).y, 0.5F, 1e-6F);
}

TEST(EnvironmentMapTest, PlacesAndDirectionsAreInverse) {
    for (float u = 0.01F; u < 1.0F; u += 0.07F) {
        for (float v = 0.02F; v < 1.0F; v += 0.06F) {
            const glm::vec3 direction = latLongDirection({u, v});
            EXPECT_NEAR(glm::length(direction), 1.0F, 1e-6F);
            const glm::vec2 place = latLong(3.0F * direction);
            EXPECT_NEAR(place.x, u, 1e-5F);
            EXPECT_NEAR(place.y, v, 1e-5F);
        }
    }
}

TEST(EnvironmentMapTest, RadianceIsThatOfTheTexel) {
    const EnvironmentMap map =
        mapOf(16, 8, [](const glm::vec3& d) { return glm::vec3(d.x > 0.9F ? 7.0F : 0.0F); });
    EXPECT_EQ(radianceFrom(map, {1, 0.05F, 0.05F}).r, 7.0F);
    EXPECT_EQ(radianceFrom(map, {-1, 0.05F, 0.05F}).r, 0.0F);
    EXPECT_EQ(radianceFrom(map, {0, 1, 0}).r, 0.0F);
}

TEST(EnvironmentMapTest, TurningMovesPlusXTowardsPlusZ) {
    const EnvironmentMap map =
        mapOf(16, 8, [](const glm::vec3& d) { return glm::vec3(d.x > 0.9F ? 7.0F : 0.0F); });
    EXPECT_EQ(radianceFrom(turned(map, 0.25F), {0, 0.05F, 1}).r, 7.0F);
    EXPECT_EQ(radianceFrom(turned(map, -0.75F), {0, 0.05F, 1}).r, 7.0F);
    EXPECT_EQ(turned(map, 1.0F).radiance, map.radiance);
    EXPECT_EQ(turned(map, 0.9999F).radiance, map.radiance) << "by whole texels";
}

TEST(EnvironmentMapTest, ABadMapIsRefusedWithNumbers) {
    EnvironmentMap map = evenSky(1.0F, 8, 4);
    EXPECT_TRUE(checkEnvironment(map));
    map.radiance[8 * 2 + 5].g = std::numeric_limits<float>::quiet_NaN();
    EXPECT_NE(checkEnvironment(map).message().find("(5, 2)"), std::string::npos);
    map.radiance[8 * 2 + 5].g = -0.5F;
    EXPECT_EQ(checkEnvironment(map).code(), StatusCode::InvalidOption);
    map = evenSky(1.0F, 8, 4);
    map.radiance.pop_back();
    EXPECT_NE(checkEnvironment(map).message().find("31"), std::string::npos);
    EXPECT_FALSE(checkEnvironment({0, 4, {}}));
    EXPECT_FALSE(checkEnvironment({20000, 4, {}}));
}

} // namespace
} // namespace aolib::lighting::test
