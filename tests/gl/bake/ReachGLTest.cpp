#include <algorithm>
#include <cmath>
#include <optional>

#include "GpuBakerFixture.h"
#include "bench/bake/MapErrors.h"

namespace aolib::bake::test {

namespace {

using bench::errorsOf;

/// Occluders that have an end, against rays with the same radius and falloff.
class ReachGLTest : public GpuBakerFixture {
protected:
    static constexpr float radius = 0.35F; ///< a tenth of the diagonal of the shapes
    static constexpr int size = 64;        ///< of maps

    static ScatterOptions points(Falloff falloff, int directions) {
        ScatterOptions options;
        options.directions = directions;
        options.radius = radius;
        options.falloff = falloff;
        return options;
    }
    static ShadowOptions depths(Falloff falloff, int directions) {
        ShadowOptions options;
        options.directions = directions;
        options.radius = radius;
        options.falloff = falloff;
        options.depthSize = 256;
        return options;
    }
    static BakedMap traced(BakeScene scene, Falloff falloff, float reach = radius) {
        RayOptions options;
        options.rays = 512;
        options.radius = reach;
        options.falloff = falloff;
        return onlyMap(**createRayBaker(std::move(scene), options), size, 8, true);
    }
};

TEST_P(ReachGLTest, OccludersWithinAStepAreThoseOfRays) {
    const BakedMap truth = traced(sceneOf(shapes()), Falloff::Step);
    EXPECT_GT(errorsOf(truthOf(shapes(), size), truth).inside, 0.3) << "endless ones are far off";
    const auto scattered =
        onlyMap(*scatter(sceneOf(shapes()), points(Falloff::Step, 128)), size, 8, true);
    EXPECT_LT(errorsOf(scattered, truth).inside, 0.045);
    EXPECT_LT(errorsOf(scattered, truth).bentAngle, 5.0);
    const auto shadowed =
        onlyMap(*shadow(sceneOf(shapes()), depths(Falloff::Step, 128)), size, 8, true);
    EXPECT_LT(errorsOf(shadowed, truth).inside, 0.025);
    EXPECT_LT(errorsOf(shadowed, truth).bentAngle, 5.0);
}

TEST_P(ReachGLTest, OccludersThatFadeAreThoseOfRays) {
    const BakedMap truth = traced(sceneOf(shapes()), Falloff::Exp);
    EXPECT_GT(errorsOf(traced(sceneOf(shapes()), Falloff::Step), truth).inside, 0.1)
        << "a step is far off";
    const auto scattered =
        onlyMap(*scatter(sceneOf(shapes()), points(Falloff::Exp, 128)), size, 8, true);
    EXPECT_LT(errorsOf(scattered, truth).inside, 0.05);
    const auto shadowed =
        onlyMap(*shadow(sceneOf(shapes()), depths(Falloff::Exp, 128)), size, 8, true);
    EXPECT_LT(errorsOf(shadowed, truth).inside, 0.035);
}

/// Floors one above the other, from 0 on up, and a ground below: of each, those within the radius
/// occlude, however many are nearer to the light. All look up, map 0 is the one at the height.
BakeScene shelves(float height) {
    BakeScene scene;
    for (const float y : {0.0F, 0.05F, 0.3F, 0.36F, 0.8F}) {
        UvMesh floor;
        addUvQuad(floor, {-0.5F, y, 0.5F}, {1.0F, 0.0F, 0.0F}, {0.0F, 0.0F, -1.0F}, 1);
        scene.surfaces.push_back(surfaceOf(floor, y == height ? 0 : -1));
    }
    return scene;
}

TEST_P(ReachGLTest, WhatHidesANearOccluderFromTheLightDoesNotOpenIt) {
    for (const float height : {0.05F, 0.3F, 0.36F}) {
        for (const float reach : {0.1F, 0.3F, 0.6F}) {
            RayOptions rays;
            rays.rays = 256;
            rays.radius = reach;
            const BakedMap truth = onlyMap(**createRayBaker(shelves(height), rays), 8);
            ScatterOptions light = points(Falloff::Step, 64);
            ShadowOptions maps = depths(Falloff::Step, 64);
            light.radius = maps.radius = reach;
            EXPECT_LT(errorsOf(onlyMap(*scatter(shelves(height), light), 8), truth).inside, 0.06)
                << height << ' ' << reach;
            EXPECT_LT(errorsOf(onlyMap(*shadow(shelves(height), maps), 8), truth).inside, 0.06)
                << height << ' ' << reach;
        }
    }
}

TEST_P(ReachGLTest, TheGroundHasAnEndToo) {
    UvMesh wall;
    addUvQuad(wall, {0.0F, 0.1F, 0.0F}, {1.0F, 0.0F, 0.0F}, {0.0F, 1.0F, 0.0F}, 1);
    BakeScene scene = sceneOf(wall);
    scene.ground = 0.0F;
    const BakedMap truth = traced(scene, Falloff::Step, 0.3F);
    EXPECT_GT(truth.visibility[60 * size + 32], 0.99F) << "far above it";
    ScatterOptions added = points(Falloff::Step, 128);
    ShadowOptions maps = depths(Falloff::Step, 128);
    added.radius = maps.radius = 0.3F;
    EXPECT_LT(errorsOf(onlyMap(*scatter(scene, added), size, 8, true), truth).inside, 0.03);
    EXPECT_LT(errorsOf(onlyMap(*shadow(scene, maps), size, 8, true), truth).inside, 0.03);
}

TEST_P(ReachGLTest, PointsAddUpAlikeDrawnOrNot) {
    ScatterOptions options = points(Falloff::Step, 4);
    options.rasterSize = 128;
    options.sum = PointSum::Blending;
    BakeScene scene = sceneOf(shapes());
    scene.ground = -0.1F;
    const BakedMap drawn = onlyMap(*scatter(scene, options), 32);
    options.sum = PointSum::Processor;
    const BakedMap added = onlyMap(*scatter(scene, options), 32);
    EXPECT_LT(errorsOf(drawn, added).inside, 0.005);
}

TEST_P(ReachGLTest, VerticesHaveItToo) {
    RayOptions rays;
    rays.radius = radius;
    const auto truth = (*createRayBaker(sceneOf(shapes()), rays))->bakeVertices({}, {});
    ASSERT_TRUE(truth.ok());
    const auto meanError = [&](AbstractBaker& baker) {
        const auto made = baker.bakeVertices({}, {});
        EXPECT_TRUE(made.ok()) << made.status().message();
        double sum = 0.0;
        for (std::size_t i = 0; i < truth->front().visibility.size(); ++i) {
            sum += std::abs(double(made->front().visibility[i]) -
                            double(truth->front().visibility[i]));
        }
        return sum / double(truth->front().visibility.size());
    };
    EXPECT_LT(meanError(*scatter(sceneOf(shapes()), points(Falloff::Step, 64))), 0.03);
    EXPECT_LT(meanError(*shadow(sceneOf(shapes()), depths(Falloff::Step, 64))), 0.03);
}

TEST_P(ReachGLTest, WhatCannotBeIsToldAndWhatIsCancelledEnds) {
    ScatterOptions few = points(Falloff::Step, 16);
    few.radius = 1e-4F;
    EXPECT_EQ(createScatterBaker(loader, sceneOf(shapes()), few).status().code(),
              StatusCode::InvalidOption);
    ShadowOptions maps = depths(Falloff::Step, 16);
    maps.radius = -1.0F;
    EXPECT_EQ(createShadowBaker(loader, sceneOf(shapes()), maps).status().code(),
              StatusCode::InvalidOption);
    MapOptions options;
    options.width = options.height = 16;
    const auto until = [](double done) { return done < 0.4; };
    EXPECT_EQ(scatter(sceneOf(shapes()), points(Falloff::Step, 16))
                  ->bakeMaps(options, until)
                  .status()
                  .code(),
              StatusCode::Cancelled);
    EXPECT_EQ(shadow(sceneOf(shapes()), depths(Falloff::Step, 16))
                  ->bakeMaps(options, until)
                  .status()
                  .code(),
              StatusCode::Cancelled);
}

// Contexts share one rasteriser; what takes seconds is done in one of them.
INSTANTIATE_TEST_SUITE_P(One, ReachGLTest, testing::Values(testContexts().front()), nameOf);

} // namespace

} // namespace aolib::bake::test
