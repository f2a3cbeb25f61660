#include <algorithm>
#include <cmath>

#include "GpuBakerFixture.h"
#include "reference/ClosedForms.h"

namespace aolib::bake::test {

namespace {

/// Bakers on the GPU against closed forms, in every kind of context.
class GpuBakerGLTest : public GpuBakerFixture {};

void expectWallsShadow(const BakedMap& map, double bound) {
    double sum = 0.0;
    int count = 0;
    for (int y = 1; y < map.height - 1; ++y) {
        for (int x = 1; x < map.width - 1; ++x) {
            const double truth = 1.0 - wallOcclusion(0.5, (x + 0.5) / map.width);
            const double error =
                double(map.visibility[static_cast<std::size_t>(y * map.width + x)]) - truth;
            sum += error * error;
            ++count;
        }
    }
    EXPECT_LT(std::sqrt(sum / count), bound);
}

TEST_P(GpuBakerGLTest, FloorBesideAWallIsAsDarkAsTheFormFactorSays) {
    ScatterOptions points;
    points.directions = 256;
    points.rasterSize = 256;
    // Of 256 directions 128 light the floor: half a direction is 0.008.
    expectWallsShadow(onlyMap(*scatter(floorBesideShortWall(), points), 16), 0.02);
    ShadowOptions maps;
    maps.directions = 256;
    maps.depthSize = 256;
    expectWallsShadow(onlyMap(*shadow(floorBesideShortWall(), maps), 16), 0.02);
}

TEST_P(GpuBakerGLTest, DepthMapsShowWhatIsLitHoweverFarItsOccludersReach) {
    // The wall is a thousand times as long as the floor; a few texels of the floor are wanted.
    ShadowOptions maps;
    maps.directions = 256;
    maps.depthSize = 256;
    const auto baker = shadow(floorBesideWall(0.5), maps);
    expectWallsShadow(onlyMap(*baker, 16), 0.02);
    MapOptions options;
    options.width = options.height = 16;
    options.wanted.assign(256, 0);
    options.wanted[8 * 16 + 2] = 1;
    options.fill = false;
    const auto one = baker->bakeMaps(options, {});
    ASSERT_TRUE(one.ok());
    EXPECT_NEAR(one->front().visibility[8 * 16 + 2], 1.0 - wallOcclusion(0.5, 2.5 / 16.0), 0.03);
}

TEST_P(GpuBakerGLTest, WantedTexelsHaveTheirValuesAndTheOthersNone) {
    ScatterOptions points;
    points.directions = 16;
    ShadowOptions depths;
    depths.directions = 16;
    depths.depthSize = 64;
    const auto scatterer = scatter(sceneOf(unitFloor(1)), points);
    const auto shadower = shadow(sceneOf(unitFloor(1)), depths);
    MapOptions options;
    options.width = options.height = 8;
    options.padding = 0;
    options.fill = false;
    for (AbstractBaker* baker : {scatterer.get(), shadower.get()}) {
        options.wanted.clear();
        const auto all = baker->bakeMaps(options, {});
        options.wanted.assign(64, 0);
        options.wanted[30] = 1;
        const auto some = baker->bakeMaps(options, {});
        ASSERT_TRUE(all.ok() && some.ok());
        for (std::size_t i = 0; i < 64; ++i) {
            EXPECT_EQ(some->front().visibility[i], i == 30 ? all->front().visibility[i] : -1.0F);
        }
    }
}

TEST_P(GpuBakerGLTest, SeveralMapsAreBakedAtOnceAndDoNotMix) {
    BakeScene scene = sceneOf(unitFloor(1));
    UvMesh cover;
    addUvQuad(cover, {-1.0F, 0.04F, -2.0F}, {3, 0, 0}, {0, 0, 3}, 1); // looks down
    scene.surfaces.push_back(surfaceOf(cover, 1));
    UvMesh roof;
    addUvQuad(roof, {-1.0F, 0.05F, 1.0F}, {3, 0, 0}, {0, 0, -3}, 1);
    scene.surfaces.push_back(surfaceOf(roof, 2));
    MapOptions options;
    options.width = options.height = 16;
    ScatterOptions points;
    points.directions = 64;
    points.rasterSize = 256;
    const auto maps = scatter(scene, points)->bakeMaps(options, {});
    ASSERT_TRUE(maps.ok()) << maps.status().message();
    ASSERT_EQ(maps->size(), 3U);
    ShadowOptions depths;
    depths.directions = 64;
    depths.depthSize = 512;
    const auto shadows = shadow(scene, depths)->bakeMaps(options, {});
    ASSERT_TRUE(shadows.ok()) << shadows.status().message();
    for (const auto* baked : {&*maps, &*shadows}) {
        const BakedMap& floor = (*baked)[0];
        const BakedMap& below = (*baked)[1];
        const BakedMap& above = (*baked)[2];
        for (std::size_t i = 0; i < 256; ++i) {
            EXPECT_LT(floor.visibility[i], 0.05F) << "below a roof";
            EXPECT_GT(above.visibility[i], 0.9F) << "the roof itself";
        }
        EXPECT_LT(below.visibility[8 * 16 + 8], 0.05F);
    }
}

TEST_P(GpuBakerGLTest, ChartsThatMeetWithinATexelDoNotMix) {
    ScatterOptions points;
    points.directions = 64;
    points.rasterSize = 256;
    points.pointSize = 1.0F;
    ShadowOptions maps;
    maps.directions = 64;
    maps.depthSize = 512;
    for (const BakedMap& map : {onlyMap(*scatter(openBesideClosedChart(), points), 4),
                                onlyMap(*shadow(openBesideClosedChart(), maps), 4)}) {
        for (std::size_t y = 0; y < 4; ++y) {
            EXPECT_GT(map.visibility[y * 4 + 1], 0.9F) << "its centre lies in the open chart";
            EXPECT_LT(map.visibility[y * 4 + 2], 0.1F);
        }
    }
}

TEST_P(GpuBakerGLTest, GroundAndDomeDarkenWhatLooksDown) {
    UvMesh wall;
    addUvQuad(wall, {0.0F, 0.5F, 0.0F}, {1.0F, 0.0F, 0.0F}, {0.0F, 1.0F, 0.0F}, 1);
    BakeScene grounded = sceneOf(wall);
    grounded.ground = 0.0F;
    ScatterOptions points;
    points.directions = 256;
    ShadowOptions maps;
    maps.directions = 256;
    maps.depthSize = 64;
    EXPECT_NEAR(onlyMap(*scatter(grounded, points), 16).visibility[8 * 16 + 8], 0.5F, 0.06F);
    EXPECT_NEAR(onlyMap(*shadow(grounded, maps), 16).visibility[8 * 16 + 8], 0.5F, 0.03F);
    points.sky = Sky::Dome;
    maps.sky = Sky::Dome;
    EXPECT_NEAR(onlyMap(*scatter(sceneOf(wall), points), 16).visibility[8 * 16 + 8], 0.5F, 0.06F);
    EXPECT_NEAR(onlyMap(*shadow(sceneOf(wall), maps), 16).visibility[8 * 16 + 8], 0.5F, 0.03F);
}

TEST_P(GpuBakerGLTest, HostStateComesBackAndTheCallbackSeesIt) {
    gl.Enable(GL_CULL_FACE);
    gl.Enable(GL_SCISSOR_TEST);
    gl.Viewport(1, 2, 3, 4);
    gl.DepthFunc(GL_GREATER);
    const auto expectHost = [&] {
        EXPECT_EQ(gl.IsEnabled(GL_CULL_FACE), GL_TRUE);
        EXPECT_EQ(gl.IsEnabled(GL_SCISSOR_TEST), GL_TRUE);
        EXPECT_EQ(gl.IsEnabled(GL_PROGRAM_POINT_SIZE), GL_FALSE);
        EXPECT_EQ(gl.IsEnabled(GL_BLEND), GL_FALSE);
        EXPECT_EQ(gl.IsEnabled(GL_DEPTH_TEST), GL_FALSE);
        GLint viewport[4] = {};
        gl.GetIntegerv(GL_VIEWPORT, viewport);
        EXPECT_EQ(viewport[3], 4);
        GLint depthFunc = 0;
        gl.GetIntegerv(GL_DEPTH_FUNC, &depthFunc);
        EXPECT_EQ(depthFunc, GL_GREATER);
        GLint framebuffer = -1;
        gl.GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &framebuffer);
        EXPECT_EQ(framebuffer, 0);
    };
    ScatterOptions points;
    points.directions = 16;
    ShadowOptions maps;
    maps.directions = 16;
    maps.depthSize = 64;
    ScatterOptions drawn = points;
    drawn.sum = PointSum::Blending;
    for (const auto& baker : {scatter(floorBesideShortWall(), points).release(),
                              scatter(floorBesideShortWall(), drawn).release(),
                              shadow(floorBesideShortWall(), maps).release()}) {
        const std::unique_ptr<AbstractBaker> owner(baker);
        MapOptions options;
        options.width = options.height = 16;
        double last = -1.0;
        EXPECT_TRUE(owner
                        ->bakeMaps(options,
                                   [&](double fraction) {
                                       expectHost();
                                       EXPECT_GE(fraction, last);
                                       last = fraction;
                                       return true;
                                   })
                        .ok());
        EXPECT_EQ(last, 1.0);
        expectHost();
        const auto cancelled = owner->bakeMaps(options, [](double done) { return done < 0.4; });
        EXPECT_EQ(cancelled.status().code(), StatusCode::Cancelled);
        expectHost();
    }
}

TEST_P(GpuBakerGLTest, PointsAddUpAlikeDrawnOrNot) {
    // Two maps, one of which is a wall's that something hides, above a ground.
    BakeScene scene = floorBesideShortWall();
    scene.surfaces[1].map = 1;
    scene.ground = -0.2F;
    MapOptions options;
    options.width = options.height = 16;
    for (const float size : {0.5F, 0.0F}) {
        ScatterOptions points;
        points.directions = 32;
        points.pointSize = size;
        points.sum = PointSum::Blending;
        const auto drawn = scatter(scene, points)->bakeMaps(options, {});
        points.sum = PointSum::Processor;
        const auto added = scatter(scene, points)->bakeMaps(options, {});
        ASSERT_TRUE(drawn.ok() && added.ok());
        ASSERT_EQ(added->size(), 2U);
        // Rounding may put a point that the nearest texel gets into the next one.
        const double bound = size > 0.0F ? 0.001 : 0.02;
        for (std::size_t map = 0; map < 2; ++map) {
            double sum = 0.0;
            for (std::size_t i = 0; i < 256; ++i) {
                sum += std::abs(double((*drawn)[map].visibility[i]) -
                                double((*added)[map].visibility[i]));
            }
            EXPECT_LT(sum / 256.0, bound) << map << ' ' << size;
        }
    }
}

TEST_P(GpuBakerGLTest, SameSeedsGiveTheSameMaps) {
    ScatterOptions options;
    options.directions = 8;
    const BakedMap first = onlyMap(*scatter(floorBesideShortWall(), options), 16);
    EXPECT_EQ(first.visibility, onlyMap(*scatter(floorBesideShortWall(), options), 16).visibility);
    options.seed = 3;
    EXPECT_NE(first.visibility, onlyMap(*scatter(floorBesideShortWall(), options), 16).visibility);
}

TEST_P(GpuBakerGLTest, EveryMisuseHasItsCode) {
    ScatterOptions points;
    points.directions = 0;
    EXPECT_EQ(createScatterBaker(loader, floorBesideShortWall(), points).status().code(),
              StatusCode::InvalidOption);
    ShadowOptions maps;
    maps.mapsPerPass = 17;
    EXPECT_EQ(createShadowBaker(loader, floorBesideShortWall(), maps).status().code(),
              StatusCode::InvalidOption);
    EXPECT_EQ(createScatterBaker(loader, {}, {}).status().code(), StatusCode::EmptyMesh);
    const ProcAddressLoader none = [](const char*) -> void* { return nullptr; };
    EXPECT_EQ(createShadowBaker(none, floorBesideShortWall(), {}).status().code(),
              StatusCode::NoContext);
    BakeScene blind = floorBesideShortWall();
    blind.surfaces[0].uvs.clear();
    EXPECT_EQ(scatter(blind, {})->bakeMaps({}, {}).status().code(), StatusCode::InvalidPosition);
}

AOLIB_FOR_ALL_CONTEXTS(GpuBakerGLTest);

} // namespace

} // namespace aolib::bake::test
