// The functions that shaders run to map directions to cube faces, run on the CPU.
#include "shared/cube_faces.h"

#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

namespace aolib::shared {
namespace {

constexpr int kFaceCount = 6;

vec3 randomDirection(std::mt19937& random) {
    std::normal_distribution<float> normal;
    const vec3 v(normal(random), normal(random), normal(random));
    return normalize(v);
}

TEST(CubeFacesTest, FacesComeInTheirOrder) {
    const vec3 axes[kFaceCount]{{1, 0, 0},  {-1, 0, 0}, {0, 1, 0},
                                {0, -1, 0}, {0, 0, 1},  {0, 0, -1}};
    for (int face = 0; face < kFaceCount; ++face) {
        EXPECT_EQ(faceForward(face), axes[face]);
        EXPECT_EQ(faceOf(axes[face]), face);
        // A camera: right x up = backwards.
        EXPECT_EQ(cross(faceRight(face), faceUp(face)), -faceForward(face));
    }
}

TEST(CubeFacesTest, DirectionsComeBack) {
    std::mt19937 random(1);
    for (int i = 0; i < 100000; ++i) {
        const vec3 direction = randomDirection(random);
        const int face = faceOf(direction);
        const vec2 uv = faceCoordinates(face, direction);
        ASSERT_TRUE(uv.x >= 0 && uv.x <= 1 && uv.y >= 0 && uv.y <= 1);
        // Texture coordinates near 0 cost 2 bits of float; 1e-6 leaves room for three.
        ASSERT_LT(length(normalize(faceDirection(face, uv)) - direction), 1e-6F);
    }
}

TEST(CubeFacesTest, CoordinatesComeBack) {
    std::mt19937 random(2);
    std::uniform_real_distribution<float> inside(0.001F, 0.999F);
    for (int i = 0; i < 100000; ++i) {
        const int face = i % kFaceCount;
        const vec2 uv(inside(random), inside(random));
        ASSERT_EQ(faceOf(faceDirection(face, uv)), face);
        ASSERT_LT(length(faceCoordinates(face, faceDirection(face, uv)) - uv), 1e-6F);
    }
}

TEST(CubeFacesTest, SolidAnglesOfTheTexelsAddUpToTheSphere) {
    constexpr int kSize = 64;
    double sum = 0.0;
    for (int face = 0; face < kFaceCount; ++face) {
        for (int y = 0; y < kSize; ++y) {
            for (int x = 0; x < kSize; ++x) {
                const vec2 uv((float(x) + 0.5F) / kSize, (float(y) + 0.5F) / kSize);
                const vec3 d = faceDirection(face, uv);
                const double cosBeta = dot(normalize(d), faceForward(face));
                sum += 4.0 / (kSize * kSize) * cosBeta * cosBeta * cosBeta;
            }
        }
    }
    // The midpoint rule errs by O(1 / kSize^2): 1.2e-4 of the sphere here.
    EXPECT_NEAR(sum, 4.0 * std::numbers::pi, 2e-4 * 4.0 * std::numbers::pi);
}

TEST(CubeFacesTest, NeighbouringFacesMeet) {
    // A direction a hair to either side of an edge lands a hair from the border on both faces.
    std::mt19937 random(3);
    std::uniform_real_distribution<float> along(-0.99F, 0.99F);
    for (int face = 0; face < kFaceCount; ++face) {
        for (int i = 0; i < 100; ++i) {
            const vec3 edge = faceForward(face) + faceRight(face) + along(random) * faceUp(face);
            const vec3 over = edge + 1e-4F * faceRight(face);
            const int other = faceOf(over);
            ASSERT_NE(other, face);
            const vec2 uv = faceCoordinates(other, over);
            const float border = min(min(uv.x, uv.y), min(1 - uv.x, 1 - uv.y));
            ASSERT_LT(border, 1e-4F);
        }
    }
}

} // namespace
} // namespace aolib::shared
