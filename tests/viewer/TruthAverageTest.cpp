#include <gtest/gtest.h>

#include <cmath>

#include "viewer/TruthAverage.h"

namespace aolib::viewer {
namespace {

Picture pictureOf(std::vector<float> visibility, std::vector<float> errors) {
    Picture picture;
    picture.width = static_cast<int>(visibility.size());
    picture.height = 1;
    picture.visibility = std::move(visibility);
    picture.standardError = std::move(errors);
    return picture;
}

TEST(TruthAverageTest, WeighsPicturesByTheirRays) {
    TruthAverage average;
    average.add(pictureOf({0.0F, 1.0F, -1.0F}, {0.4F, 0.4F, -1.0F}), 2);
    average.add(pictureOf({1.0F, 1.0F, -1.0F}, {0.2F, 0.2F, -1.0F}), 6);
    EXPECT_EQ(average.rays(), 8);
    const FloatImage mean = average.visibility();
    EXPECT_FLOAT_EQ(mean.at(0, 0), 0.75F);
    EXPECT_FLOAT_EQ(mean.at(1, 0), 1.0F);
    EXPECT_EQ(mean.at(2, 0), backgroundValue);
    // Errors of independent pictures: (2^2 0.4^2 + 6^2 0.2^2) / 8^2 for either pixel.
    EXPECT_NEAR(average.noise(), std::sqrt(0.64 + 1.44) / 8.0, 1e-6);
}

TEST(TruthAverageTest, BeginsAnew) {
    TruthAverage average;
    average.add(pictureOf({0.5F, 0.5F}, {0.1F, 0.1F}), 8);
    average.clear();
    average.add(pictureOf({0.25F}, {0.1F}), 2);
    EXPECT_EQ(average.visibility().width, 1);
    EXPECT_FLOAT_EQ(average.visibility().at(0, 0), 0.25F);
}

TEST(TruthAverageTest, PassesBeginShortAndReachWhatIsWanted) {
    EXPECT_EQ(raysOfNextPass(0, 256), 2);
    for (const int wanted : {2, 3, 16, 100, 256, 1000}) {
        int traced = 0;
        int passes = 0;
        while (traced < wanted) {
            const int pass = raysOfNextPass(traced, wanted);
            ASSERT_GE(pass, 2);
            ASSERT_LE(pass, 32);
            traced += pass;
            ASSERT_LT(++passes, 200);
        }
        EXPECT_LE(traced, wanted + 1) << wanted;
    }
}

} // namespace
} // namespace aolib::viewer
