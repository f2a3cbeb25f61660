#include <vector>

#include "GpuBakerFixture.h"
#include "bench/bake/MapErrors.h"

namespace aolib::bake::test {

namespace {

/// Bakes on the GPU that are watched, and ended where the watch says so.
class WatchGLTest : public GpuBakerFixture {
protected:
    static MapOptions mapOf(int size) {
        MapOptions options;
        options.width = options.height = size;
        return options;
    }
    static SnapshotCallback until(int directions) {
        return [directions](BakeSnapshot& snapshot) { return snapshot.samples() < directions; };
    }
    static void expectSame(const Result<std::vector<BakedMap>>& a,
                           const Result<std::vector<BakedMap>>& b) {
        ASSERT_TRUE(a.ok() && b.ok());
        ASSERT_EQ(a->size(), b->size());
        for (std::size_t i = 0; i < a->size(); ++i) {
            EXPECT_EQ((*a)[i].visibility, (*b)[i].visibility);
            EXPECT_EQ((*a)[i].bentNormal, (*b)[i].bentNormal);
        }
    }
};

TEST_P(WatchGLTest, ScatteringThatIsEndedIsThatOfSoManyDirections) {
    for (const PointSum sum : {PointSum::Blending, PointSum::Processor}) {
        ScatterOptions options;
        options.sum = sum;
        options.directions = 48;
        const auto ended = scatter(sceneOf(shapes()), options)->bakeMaps(mapOf(16), {}, until(16));
        options.directions = 16;
        expectSame(ended, scatter(sceneOf(shapes()), options)->bakeMaps(mapOf(16), {}));
    }
}

TEST_P(WatchGLTest, ShadowMapsThatAreEndedAreThoseOfSoManyDirections) {
    ShadowOptions options;
    options.directions = 128;
    options.depthSize = 64;
    MapOptions map = mapOf(16);
    map.texelSamples = 1;
    const auto ended = shadow(sceneOf(shapes()), options)->bakeMaps(map, {}, until(64));
    options.directions = 64;
    expectSame(ended, shadow(sceneOf(shapes()), options)->bakeMaps(map, {}));
}

TEST_P(WatchGLTest, MapsThatNoTextureHoldsTogetherGetAlikeManyDirections) {
    BakeScene scene = sceneOf(unitFloor(1));
    scene.surfaces.resize(3, scene.surfaces[0]);
    for (int i = 0; i < 3; ++i) {
        scene.surfaces[static_cast<std::size_t>(i)].map = i;
        for (glm::vec3& position : scene.surfaces[static_cast<std::size_t>(i)].positions) {
            position.y += 0.5F * float(i);
        }
    }
    ScatterOptions options;
    options.sum = PointSum::Blending;
    options.directions = 16;
    options.rasterSize = 64;
    MapOptions map;
    map.width = 1;
    map.height = gl.capabilities.maxTextureSize / 2; // two in a texture
    map.fill = false;
    std::vector<int> told;
    const auto watch = [&](BakeSnapshot& snapshot) {
        told.push_back(snapshot.samples());
        return snapshot.samples() < 8;
    };
    const auto ended = scatter(scene, options)->bakeMaps(map, {}, watch);
    EXPECT_EQ(told, (std::vector<int>{4, 8}));
    options.directions = 8;
    expectSame(ended, scatter(scene, options)->bakeMaps(map, {}));
}

TEST_P(WatchGLTest, MoreDirectionsAreNearerToTheTruthAndTheHostsStateIsItsOwn) {
    const BakedMap truth = truthOf(shapes(), 32);
    gl.Enable(GL_SCISSOR_TEST);
    for (const bool points : {true, false}) {
        ScatterOptions scattered;
        scattered.directions = 64;
        scattered.sum = PointSum::Blending;
        ShadowOptions depths;
        depths.directions = 64;
        depths.depthSize = 256;
        depths.mapsPerPass = 4;
        const auto baker =
            points ? scatter(sceneOf(shapes()), scattered) : shadow(sceneOf(shapes()), depths);
        double first = 0.0;
        double last = 0.0;
        const auto watch = [&](BakeSnapshot& snapshot) {
            EXPECT_EQ(gl.IsEnabled(GL_SCISSOR_TEST), GL_TRUE);
            if (snapshot.samples() == 8 || snapshot.samples() == 64) {
                const auto maps = snapshot.maps();
                EXPECT_TRUE(maps.ok());
                (snapshot.samples() == 8 ? first : last) =
                    bench::errorsOf(maps->front(), truth).inside;
            }
            EXPECT_EQ(gl.IsEnabled(GL_SCISSOR_TEST), GL_TRUE);
            return true;
        };
        ASSERT_TRUE(baker->bakeMaps(mapOf(32), {}, watch).ok());
        EXPECT_LT(first, 0.25) << "eight directions are a picture already";
        EXPECT_LT(last, first / 2.0);
    }
}

// Contexts share one rasteriser; what takes seconds is done in one of them.
INSTANTIATE_TEST_SUITE_P(One, WatchGLTest, testing::Values(testContexts().front()), nameOf);

} // namespace

} // namespace aolib::bake::test
