#include "bench/CreaseWeld.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace aolib::bench {
namespace {

const glm::vec3 kUp{0.0F, 1.0F, 0.0F};

TEST(CreaseWeld, JoinsWhatLiesTogetherAndFacesAlike) {
    CreaseWeld weld(1.0F);
    const std::uint32_t first = weld.add({1.0F, 2.0F, 3.0F}, kUp, 2.0F);
    const glm::vec3 tilted = glm::normalize(glm::vec3(0.3F, 1.0F, 0.0F));
    EXPECT_EQ(weld.add({1.0F, 2.0F, 3.00001F}, tilted, 2.0F), first);
    ASSERT_EQ(weld.vertices().size(), 1U);
    EXPECT_FLOAT_EQ(weld.vertices()[0].area, 4.0F);
    EXPECT_NEAR(glm::distance(weld.vertices()[0].unitNormal(), glm::normalize(kUp + tilted)), 0.0F,
                1e-6F);
}

TEST(CreaseWeld, SplitsAtACrease) {
    CreaseWeld weld(1.0F);
    const std::uint32_t up = weld.add(glm::vec3(0.0F), kUp, 1.0F);
    const std::uint32_t side = weld.add(glm::vec3(0.0F), {1.0F, 0.0F, 0.0F}, 1.0F);
    const std::uint32_t down = weld.add(glm::vec3(0.0F), -kUp, 1.0F);
    EXPECT_NE(up, side);
    EXPECT_NE(up, down);
    EXPECT_EQ(weld.add(glm::vec3(0.0F), {1.0F, 0.0F, 0.0F}, 1.0F), side);
    EXPECT_EQ(weld.vertices().size(), 3U);
}

TEST(CreaseWeld, KeepsPlacesApart) {
    CreaseWeld weld(1.0F);
    EXPECT_NE(weld.add(glm::vec3(0.0F), kUp, 1.0F), weld.add({0.01F, 0.0F, 0.0F}, kUp, 1.0F));
}

} // namespace
} // namespace aolib::bench
