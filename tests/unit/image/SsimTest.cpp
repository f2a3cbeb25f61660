#include "image/Ssim.h"

#include <cmath>

#include <gtest/gtest.h>

namespace aolib {
namespace {

/// A wavy picture with values from 0.1 to 0.9.
FloatImage waves(int width, int height, float phase) {
    FloatImage image(width, height, 1);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            image.at(x, y) = 0.5F + 0.4F * std::sin(0.7F * static_cast<float>(x) +
                                                    0.4F * static_cast<float>(y) + phase);
        }
    }
    return image;
}

TEST(Ssim, EqualPicturesAreOne) {
    EXPECT_NEAR(*meanSsim(waves(24, 17, 0.0F), waves(24, 17, 0.0F)), 1.0, 1e-12);
}

/// Constant pictures: only the term of the means is left.
TEST(Ssim, ConstantPicturesByHand) {
    const double expected = (2.0 * 0.5 * 0.75 + 1e-4) / (0.25 + 0.5625 + 1e-4);
    EXPECT_NEAR(*meanSsim(FloatImage(11, 11, 1, 0.5F), FloatImage(11, 11, 1, 0.75F)), expected,
                1e-12);
}

/// One window, its moments summed in the plainest way.
TEST(Ssim, OneWindowByHand) {
    const FloatImage a = waves(11, 11, 0.0F);
    const FloatImage b = waves(11, 11, 0.6F);
    double weights = 0.0;
    double meanA = 0.0;
    double meanB = 0.0;
    const auto weight = [](int x, int y) {
        return std::exp(-((x - 5) * (x - 5) + (y - 5) * (y - 5)) / (2.0 * 1.5 * 1.5));
    };
    for (int y = 0; y < 11; ++y) {
        for (int x = 0; x < 11; ++x) {
            weights += weight(x, y);
            meanA += weight(x, y) * double{a.at(x, y)};
            meanB += weight(x, y) * double{b.at(x, y)};
        }
    }
    meanA /= weights;
    meanB /= weights;
    double varianceA = 0.0;
    double varianceB = 0.0;
    double covariance = 0.0;
    for (int y = 0; y < 11; ++y) {
        for (int x = 0; x < 11; ++x) {
            const double w = weight(x, y) / weights;
            const double da = double{a.at(x, y)} - meanA;
            const double db = double{b.at(x, y)} - meanB;
            varianceA += w * da * da;
            varianceB += w * db * db;
            covariance += w * da * db;
        }
    }
    const double expected =
        (2 * meanA * meanB + 1e-4) * (2 * covariance + 9e-4) /
        ((meanA * meanA + meanB * meanB + 1e-4) * (varianceA + varianceB + 9e-4));
    EXPECT_LT(expected, 0.95);
    EXPECT_NEAR(*meanSsim(a, b), expected, 1e-9);
}

/// All 14 x 7 windows together are the mean of each alone: no row or column is skipped or mixed up.
TEST(Ssim, IsTheMeanOverAllWindows) {
    const FloatImage a = waves(24, 17, 0.0F);
    FloatImage b = waves(24, 17, 0.5F);
    b.at(3, 4) = 1.0F;
    const auto part = [](const FloatImage& image, int left, int bottom) {
        FloatImage window(11, 11, 1);
        for (int y = 0; y < 11; ++y) {
            for (int x = 0; x < 11; ++x) {
                window.at(x, y) = image.at(left + x, bottom + y);
            }
        }
        return window;
    };
    double sum = 0.0;
    for (int bottom = 0; bottom < 7; ++bottom) {
        for (int left = 0; left < 14; ++left) {
            sum += *meanSsim(part(a, left, bottom), part(b, left, bottom));
        }
    }
    EXPECT_NEAR(*meanSsim(a, b), sum / 98.0, 1e-12);
}

/// Background at one end leaves only the windows that do not touch it.
TEST(Ssim, WindowsWithBackgroundDoNotCount) {
    FloatImage a = waves(22, 11, 0.0F);
    FloatImage b = waves(22, 11, 0.0F);
    for (int x = 0; x < 11; ++x) {
        b.at(x, 0) = 0.0F; // a difference that only windows with background see
        a.at(x, 5) = backgroundValue;
    }
    EXPECT_NEAR(*meanSsim(a, b), 1.0, 1e-12);
    EXPECT_NEAR(*meanSsim(b, a), 1.0, 1e-12);
    b.at(12, 5) = backgroundValue;
    EXPECT_FALSE(meanSsim(a, b));
}

TEST(Ssim, SmallPicturesHaveNoWindow) {
    EXPECT_FALSE(meanSsim(FloatImage(10, 40, 1), FloatImage(10, 40, 1)));
    EXPECT_FALSE(meanSsim(FloatImage(40, 10, 1), FloatImage(40, 10, 1)));
}

} // namespace
} // namespace aolib
