#include <gtest/gtest.h>

#include "bench/poses/PoseRun.h"
#include "content/generated/AnimatedModels.h"

namespace aolib::bench {
namespace {

TEST(PoseRunTest, MorePosesComeNearerAndBothBeatTheModelAtRest) {
    const Result<std::string, LoadError> bytes = animatedModel("bellows");
    ASSERT_TRUE(bytes) << bytes.error().sentence;
    const Result<MovingGltf, LoadError> moving = MovingGltf::open(*bytes, "bellows.glb");
    ASSERT_TRUE(moving) << moving.error().sentence;
    PosePlan plan;
    plan.name = "bellows";
    plan.model = &*moving;
    plan.poses = {2, 5};
    plan.tests = 4;
    plan.rays = 64;
    const auto rows = runPosePlan(plan, [](double) { return true; });
    ASSERT_TRUE(rows) << rows.status().message();
    ASSERT_EQ(rows->size(), 2U);
    const PoseRow& few = rows->at(0);
    const PoseRow& more = rows->at(1);
    EXPECT_GT(few.rest, 0.08);
    EXPECT_LT(few.byTime, 0.7 * few.rest);
    EXPECT_LT(more.byTime, 0.7 * few.byTime);
    EXPECT_LT(more.byParameters, 0.8 * few.byParameters);
    EXPECT_LT(more.byTime, 3.0 * more.noise) << "near to what two bakes differ by";
    EXPECT_LT(more.byTimeAngle, 0.7 * few.byTimeAngle);
    EXPECT_LT(more.byTimeAngle, 0.7 * more.restAngle);
    EXPECT_EQ(runPosePlan(plan, [](double) { return false; }).status().code(),
              StatusCode::Cancelled);
}

} // namespace
} // namespace aolib::bench
