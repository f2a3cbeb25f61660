#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include <aolib/bake/PoseBlend.h>

namespace aolib::bake {
namespace {

using Weights = std::vector<float>;

TEST(PoseBlendTest, TimesBetweenTwoPosesTakeBoth) {
    const Weights times{0.0F, 1.0F, 3.0F};
    EXPECT_EQ(poseWeightsAt(times, 0.25F), (Weights{0.75F, 0.25F, 0.0F}));
    EXPECT_EQ(poseWeightsAt(times, 2.0F), (Weights{0.0F, 0.5F, 0.5F}));
    EXPECT_EQ(poseWeightsAt(times, 1.0F), (Weights{0.0F, 1.0F, 0.0F}));
    EXPECT_EQ(poseWeightsAt(times, -1.0F), (Weights{1.0F, 0.0F, 0.0F}));
    EXPECT_EQ(poseWeightsAt(times, 7.0F), (Weights{0.0F, 0.0F, 1.0F}));
    EXPECT_EQ(poseWeightsAt(Weights{5.0F}, 0.0F), (Weights{1.0F}));
}

TEST(PoseBlendTest, ParametersAreRebuilt) {
    const std::vector<Weights> corners{{0, 0}, {1, 0}, {0, 1}};
    const auto weights = poseWeightsFor(corners, Weights{0.25F, 0.5F});
    ASSERT_TRUE(weights);
    // What nearness is worth: a thousandth.
    EXPECT_NEAR((*weights)[0], 0.25F, 2e-3F);
    EXPECT_NEAR((*weights)[1], 0.25F, 2e-3F);
    EXPECT_NEAR((*weights)[2], 0.5F, 2e-3F);
}

TEST(PoseBlendTest, OnALineTheNeighboursCount) {
    const std::vector<Weights> line{{0}, {1}, {2}, {3}, {4}};
    const auto weights = poseWeightsFor(line, Weights{1.5F});
    ASSERT_TRUE(weights);
    float sum = 0.0F;
    for (const float weight : *weights) {
        sum += weight;
    }
    EXPECT_NEAR(sum, 1.0F, 1e-5F);
    EXPECT_GT((*weights)[1], 0.3F);
    EXPECT_GT((*weights)[2], 0.3F);
    EXPECT_GT((*weights)[1], 3.0F * (*weights)[0]);
    EXPECT_GT((*weights)[2], 3.0F * (*weights)[4]);
}

TEST(PoseBlendTest, AtAPoseItStandsAlone) {
    const std::vector<Weights> poses{{0, 3}, {1, -1}, {1, 1}};
    EXPECT_EQ(*poseWeightsFor(poses, Weights{1, -1}), (Weights{0, 1, 0}));
    EXPECT_EQ(*poseWeightsFor(std::vector<Weights>{{5}}, Weights{2}), (Weights{1}));
}

TEST(PoseBlendTest, PosesThatAreTheSameShare) {
    const auto weights = poseWeightsFor(std::vector<Weights>{{1}, {1}}, Weights{2});
    ASSERT_TRUE(weights);
    EXPECT_NEAR((*weights)[0], 0.5F, 1e-4F);
    EXPECT_NEAR((*weights)[1], 0.5F, 1e-4F);
}

TEST(PoseBlendTest, ValuesAreSummedAndCut) {
    const std::vector<Weights> poses{{0.2F, 1.0F}, {0.6F, 0.9F}};
    const auto half = blendPoses(poses, Weights{0.5F, 0.5F});
    ASSERT_TRUE(half);
    EXPECT_NEAR((*half)[0], 0.4F, 1e-6F);
    EXPECT_EQ((*blendPoses(poses, Weights{2.0F, -1.0F}))[0], 0.0F);
    EXPECT_EQ((*blendPoses(poses, Weights{2.0F, -1.0F}))[1], 1.0F);
}

TEST(PoseBlendTest, NormalsAreSummedAndMadeOneUnitLong) {
    const std::vector<std::vector<glm::vec3>> poses{
        {{1.0F, 0.0F, 0.0F}, {0.0F, 1.0F, 0.0F}},
        {{0.0F, 0.0F, 1.0F}, {0.0F, -1.0F, 0.0F}},
    };
    const std::vector<float> half{0.5F, 0.5F};
    const auto middle = blendPoseNormals(poses, half);
    ASSERT_TRUE(middle);
    EXPECT_NEAR((*middle)[0].x, std::sqrt(0.5F), 1e-6F);
    EXPECT_NEAR((*middle)[0].z, std::sqrt(0.5F), 1e-6F);
    EXPECT_EQ((*middle)[1], glm::vec3(0.0F, 1.0F, 0.0F)) << "opposite ones: a pose's own";
    const std::vector<float> one{1.0F};
    EXPECT_EQ(blendPoseNormals(poses, one).status().code(), StatusCode::InvalidOption);
}

TEST(PoseBlendTest, MistakesAreNamed) {
    const std::vector<Weights> poses{{0, 1}, {1}};
    EXPECT_EQ(poseWeightsFor({}, Weights{1}).status().code(), StatusCode::InvalidOption);
    EXPECT_EQ(poseWeightsFor(poses, Weights{0, 1}).status().code(), StatusCode::InvalidOption);
    const std::vector<Weights> nan{{std::numeric_limits<float>::quiet_NaN()}};
    EXPECT_FALSE(poseWeightsFor(nan, Weights{1}));
    EXPECT_FALSE(blendPoses(poses, Weights{1, 0}));
    EXPECT_FALSE(blendPoses(std::vector<Weights>{{0}}, Weights{1, 0}));
}

} // namespace
} // namespace aolib::bake
