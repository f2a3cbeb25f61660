// What cube maps do not know of a view at rest, traced for its pixels.
#include <utility>

#include "ProgressiveTest.h"

namespace aolib {
namespace {

class ViewRepairGLTest : public ProgressiveTest {};

/// A fence: bars that are narrower than a texel and at times than a pixel.
Model fence() {
    Model model;
    addQuad(model, {-8, 0, -8}, {-8, 0, 8}, {8, 0, 8}, {8, 0, -8});
    for (int i = 0; i < 40; ++i) {
        const float x = -4.0F + 0.2F * static_cast<float>(i);
        addBox(model, {x, 0, -0.02F}, {x + 0.05F, 1.5F, 0.02F});
    }
    return model;
}

TEST_P(ViewRepairGLTest, LayeredIntervalsAreRepairedWhereThereIsATracer) {
    Options o = options(Estimator::LayeredIntervals);
    SmallHost traced = hostWith(options(Estimator::RayTraced), fence());
    SmallHost layered = hostWith(o, fence());
    o.cubeMaps.refineStaticViews = false;
    SmallHost plain = hostWith(o, fence());
    for (SmallHost* host : {&traced, &layered, &plain}) {
        ASSERT_TRUE(host->ao().addCubeMap({0.5F, 3, 5}).ok());
        ASSERT_GT(converge(*host), 0);
    }
    EXPECT_GT(layered.ao().statistics().pixelsRefined, 500U);
    EXPECT_EQ(plain.ao().statistics().pixelsRefined, 0U);
    const Picture truth = traced.visibility().visibility;
    EXPECT_LT(rmse(layered.visibility().visibility, truth),
              0.7 * rmse(plain.visibility().visibility, truth));
    // A radius makes another question of it.
    o.cubeMaps.refineStaticViews = true;
    o.radius = 0.1F;
    const float budget = std::exchange(o.frameBudget, 1e-6F); // no frame does all at once
    ASSERT_TRUE(layered.ao().setOptions(o).ok());
    ASSERT_TRUE(layered.frame().ok());
    EXPECT_EQ(layered.ao().statistics().pixelsRefined, 0U);
    o.frameBudget = budget;
    ASSERT_TRUE(layered.ao().setOptions(o).ok());
    ASSERT_GT(converge(layered), 0);
    EXPECT_GT(rmse(layered.visibility().visibility, truth), 0.05);
}

TEST_P(ViewRepairGLTest, RepairLastsUntilTheViewMovesAndComesBack) {
    Options o = options(Estimator::RayTraced);
    o.frameBudget = 0.0F;
    SmallHost host = hostWith(o, fence());
    ASSERT_TRUE(host.ao().addCubeMap({0.5F, 3, 5}).ok());
    ASSERT_GT(converge(host), 0);
    host.lookAt({0.6F, 3, 5}, {0, 0.5F, 0});
    ASSERT_GT(converge(host), 0); // what both views ask of the cube map is there
    host.lookAt({0.5F, 3, 5}, {0, 0.5F, 0});
    ASSERT_TRUE(host.frame().ok());
    EXPECT_FALSE(host.ao().statistics().converged) << "a view that was seen once may be moving";
    const Picture moving = host.visibility().visibility;
    ASSERT_TRUE(host.frame().ok());
    EXPECT_TRUE(host.ao().statistics().converged);
    const Picture resting = host.visibility().visibility;
    EXPECT_GT(largestChange(moving, resting), 0.05);
    host.lookAt({0.6F, 3, 5}, {0, 0.5F, 0});
    ASSERT_TRUE(host.frame().ok());
    EXPECT_EQ(host.ao().statistics().pixelsRefined, 0U);
    host.lookAt({0.5F, 3, 5}, {0, 0.5F, 0});
    ASSERT_TRUE(host.frame().ok());
    EXPECT_EQ(host.visibility().visibility, moving);
    ASSERT_TRUE(host.frame().ok());
    EXPECT_EQ(host.visibility().visibility, resting);
}

TEST_P(ViewRepairGLTest, RepairStaysWhenCubeMapsComeAndGo) {
    SmallHost host = hostWith(options(Estimator::RayTraced), fence());
    const CubeMapId first = *host.ao().addCubeMap({0.5F, 3, 5});
    ASSERT_GT(converge(host), 0);
    const Picture before = host.visibility().visibility;
    ASSERT_TRUE(host.ao().addCubeMap({-2, 2, 4}).ok());
    ASSERT_TRUE(host.frame().ok());
    EXPECT_EQ(host.visibility().visibility, before) << "it is not shown yet";
    EXPECT_FALSE(host.ao().statistics().converged);
    ASSERT_GT(converge(host), 0);
    EXPECT_LT(rmse(host.visibility().visibility, before), 0.01);
    ASSERT_TRUE(host.ao().removeCubeMap(first).ok());
    ASSERT_GT(converge(host), 0);
    EXPECT_LT(rmse(host.visibility().visibility, before), 0.02)
        << "what only the first knew is traced";
}

/// What the host draws without describing it hides what was traced for its pixels, and is not
/// traced itself.
TEST_P(ViewRepairGLTest, RepairHoldsForTheDepthThatItWasTracedFor) {
    Options o = options(Estimator::RayTraced);
    o.frameBudget = 0.0F;
    SmallHost host = hostWith(o, fence());
    ASSERT_TRUE(host.ao().addCubeMap({0.5F, 3, 5}).ok());
    ASSERT_GT(converge(host), 0);
    const Picture before = host.visibility().visibility;
    Model intruder = fence();
    addBox(intruder, {-8, 0.1F, 1}, {8, 0.6F, 2});
    auto other = host::HostRenderer::create(gl, intruder);
    ASSERT_TRUE(other.ok());
    std::swap(host.renderer(), *other);
    ASSERT_TRUE(host.frame().ok());
    const Picture during = host.visibility().visibility;
    std::swap(host.renderer(), *other);
    ASSERT_TRUE(host.frame().ok());
    EXPECT_EQ(host.visibility().visibility, before) << "the pixels are what they were";
    EXPECT_GT(largestChange(during, before), 0.1);
    o.cubeMaps.refineStaticViews = false;
    ASSERT_TRUE(host.ao().setOptions(o).ok());
    std::swap(host.renderer(), *other);
    ASSERT_TRUE(host.frame().ok());
    const Picture plain = host.visibility().visibility;
    std::size_t own = 0; // pixels of the intruder, as wherever nothing was traced
    for (std::size_t i = 0; i < plain.size(); ++i) {
        own += during[i] == plain[i] ? 1U : 0U;
    }
    EXPECT_GT(own, plain.size() / 2);
}

AOLIB_FOR_ALL_CONTEXTS(ViewRepairGLTest);

} // namespace
} // namespace aolib
