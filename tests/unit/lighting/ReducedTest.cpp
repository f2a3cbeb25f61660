#include <gtest/gtest.h>

#include "TestSkies.h"
#include "lighting/Reduced.h"

namespace aolib::lighting::test {
namespace {

TEST(ReducedTest, SizesAreThoseOfMipmaps) {
    EnvironmentMap map = evenSky(2.0F, 13, 6);
    map = halved(map);
    EXPECT_EQ(map.width, 6);
    EXPECT_EQ(map.height, 3);
    map = halved(halved(map));
    EXPECT_EQ(map.width, 1);
    EXPECT_EQ(map.height, 1);
    EXPECT_NEAR(map.radiance[0].g, 2.0F, 1e-6F);
}

TEST(ReducedTest, MeansAreBySteradians) {
    // A row at a pole covers less of the sphere than the one beside it.
    const EnvironmentMap map =
        mapOf(4, 4, [](const glm::vec3& d) { return glm::vec3(d.y > 0.9F ? 1.0F : 0.0F); });
    const EnvironmentMap half = halved(map);
    // Rows end at latitudes 90, 45 and 0: (1 - sin 45) of 1.
    EXPECT_NEAR(half.radiance[2].r, 1.0F - 0.70711F, 1e-4F);
    EXPECT_NEAR(half.radiance[0].r, 0.0F, 1e-6F);
}

TEST(ReducedTest, OddSizesLoseNoTexel) {
    EnvironmentMap map = evenSky(0.0F, 3, 1);
    map.radiance[1] = glm::vec3(3.0F);
    EXPECT_NEAR(halved(map).radiance[0].r, 1.0F, 1e-6F);
    map = evenSky(0.0F, 5, 1);
    map.radiance[2] = glm::vec3(5.0F); // half of it to each side
    const EnvironmentMap half = halved(map);
    EXPECT_NEAR(half.radiance[0].r, 1.0F, 1e-6F);
    EXPECT_NEAR(half.radiance[1].r, 1.0F, 1e-6F);
}

TEST(ReducedTest, AMapThatIsSmallEnoughStays) {
    EXPECT_EQ(reduced(evenSky(1.0F, 64, 32), 32).height, 32);
    EXPECT_EQ(reduced(evenSky(1.0F, 64, 33), 32).height, 16);
}

} // namespace
} // namespace aolib::lighting::test
