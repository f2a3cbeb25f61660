#include "content/generated/Pcg.h"

#include <gtest/gtest.h>

namespace aolib {
namespace {

TEST(PcgTest, GivesTheNumbersOfItsDefinition) {
    // Worked out from the published recurrence in integers of unlimited width.
    Pcg random(42);
    for (const std::uint32_t expected :
         {0xC2F57BD6U, 0x6B07C4A9U, 0x72B7B29BU, 0x44215383U, 0xF5AF5EADU}) {
        EXPECT_EQ(random.next(), expected);
    }
}

TEST(PcgTest, StaysInRange) {
    Pcg random(7);
    int counts[3] = {0, 0, 0};
    for (int i = 0; i < 3000; ++i) {
        const float value = random.uniform(-2.0F, 3.0F);
        EXPECT_GE(value, -2.0F);
        EXPECT_LT(value, 3.0F);
        ++counts[random.pick(3)];
    }
    for (const int count : counts) {
        EXPECT_NEAR(count, 1000, 150);
    }
}

} // namespace
} // namespace aolib
