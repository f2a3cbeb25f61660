#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include <aolib/lighting/Sun.h>

#include "TestSkies.h"
#include "content/generated/Environments.h"

namespace aolib::lighting::test {
namespace {

SplitEnvironment splitOf(const char* name) {
    return splitSun(findGeneratedEnvironment(name)->build());
}

TEST(SunTest, TheSunIsWhereItWasPut) {
    const SplitEnvironment split = splitOf("sunny");
    ASSERT_TRUE(split.sun);
    const float up = glm::radians(40.0F);
    const float along = glm::radians(60.0F);
    const glm::vec3 towards(std::cos(up) * std::cos(along), std::sin(up),
                            std::cos(up) * std::sin(along));
    // Texels are 0.7 degrees wide.
    EXPECT_GT(glm::dot(split.sun->direction, towards), std::cos(glm::radians(0.35F)));
    EXPECT_NEAR(glm::degrees(split.sun->radius), 1.5F, 0.25F);
    // Within the share of its disc's texels that lie half in it.
    EXPECT_NEAR(split.sun->irradiance.r, 4.0F, 0.6F);
    EXPECT_NEAR(split.sun->irradiance.b / split.sun->irradiance.r, 0.85F, 0.03F);
}

TEST(SunTest, TheRestHasNoSunAndNothingIsLost) {
    const EnvironmentMap whole = findGeneratedEnvironment("sunny")->build();
    const SplitEnvironment split = splitSun(whole);
    float brightest = 0.0F;
    glm::dvec3 lost(0.0);
    for (int y = 0; y < whole.height; ++y) {
        const double low = std::sin(3.14159265358979 * (double(y) / whole.height - 0.5));
        const double high = std::sin(3.14159265358979 * (double(y + 1) / whole.height - 0.5));
        for (int x = 0; x < whole.width; ++x) {
            const std::size_t texel = std::size_t(y) * std::size_t(whole.width) + std::size_t(x);
            brightest = std::max(brightest, split.rest.radiance[texel].r);
            lost += 2.0 * 3.14159265358979 / whole.width * (high - low) *
                    glm::dvec3(whole.radiance[texel] - split.rest.radiance[texel]);
        }
    }
    EXPECT_LT(brightest, 1.01F);
    EXPECT_NEAR(lost.r, double(split.sun->irradiance.r), 1e-3);
    EXPECT_NEAR(lost.b, double(split.sun->irradiance.b), 1e-3);
}

TEST(SunTest, SoftAndWideLightIsNoSun) {
    for (const char* name : {"overcast", "studio", "window"}) {
        const SplitEnvironment split = splitOf(name);
        EXPECT_FALSE(split.sun) << name;
        EXPECT_EQ(split.rest.radiance, findGeneratedEnvironment(name)->build().radiance) << name;
    }
    EXPECT_FALSE(splitSun(evenSky(0.0F)).sun) << "darkness";
    EXPECT_FALSE(splitSun(evenSky(1.0F, 1, 1)).sun);
}

TEST(SunTest, AWeakSpotStaysInTheMap) {
    // A hundredth of the light of the sky.
    EnvironmentMap map = evenSky(1.0F, 256, 128);
    map.radiance[256 * 90 + 30] = glm::vec3(100.0F);
    EXPECT_FALSE(splitSun(map).sun);
    map.radiance[256 * 90 + 30] = glm::vec3(30000.0F);
    EXPECT_TRUE(splitSun(map).sun);
}

TEST(SunTest, LightFallsWithTheCosine) {
    const Sun sun{{0.0F, 1.0F, 0.0F}, glm::vec3(3.14159265F), 0.01F};
    EXPECT_NEAR(sunLight(sun, {0, 1, 0}).g, 1.0F, 1e-5F);
    EXPECT_NEAR(sunLight(sun, glm::normalize(glm::vec3(1, 1, 0))).g, 0.70711F, 1e-4F);
    EXPECT_EQ(sunLight(sun, {0, -1, 0}).g, 0.0F);
}

} // namespace
} // namespace aolib::lighting::test
