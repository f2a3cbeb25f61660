#include <algorithm>

#include "GpuBakerFixture.h"
#include "bench/bake/MapErrors.h"

namespace aolib::bake::test {

namespace {

using bench::errorsOf;
using bench::MapErrors;

/// How far bakers on the GPU are from rays.
class BakeAccuracyGLTest : public GpuBakerFixture {};

TEST_P(BakeAccuracyGLTest, LoneBoxIsOpenUpToItsSeams) {
    const UvMesh box = uvShape("uv-box");
    ScatterOptions points;
    points.directions = 128;
    const BakedMap open = truthOf(box, 64);
    const MapErrors scattered = errorsOf(onlyMap(*scatter(sceneOf(box), points), 64, 8), open);
    EXPECT_LT(scattered.inside, 0.03);
    EXPECT_LT(scattered.seams, 0.04);
    ShadowOptions maps;
    maps.directions = 128;
    maps.depthSize = 256;
    const MapErrors shadowed = errorsOf(onlyMap(*shadow(sceneOf(box), maps), 64, 8), open);
    EXPECT_LT(shadowed.inside, 0.03);
    EXPECT_LT(shadowed.seams, 0.03);
}

TEST_P(BakeAccuracyGLTest, RoomWithoutOpeningIsClosed) {
    UvMesh room;
    addUvBox(room, glm::vec3(-1.0F), glm::vec3(1.0F), 2, {}, true);
    ScatterOptions points;
    points.directions = 64;
    ShadowOptions maps;
    maps.directions = 64;
    maps.depthSize = 512;
    for (const BakedMap& map : {onlyMap(*scatter(sceneOf(room), points), 64),
                                onlyMap(*shadow(sceneOf(room), maps), 64)}) {
        double sum = 0.0;
        double most = 0.0;
        int count = 0;
        for (std::size_t i = 0; i < map.visibility.size(); ++i) {
            if (map.kind[i] == TexelKind::Inside) {
                sum += double(map.visibility[i]);
                most = std::max(most, double(map.visibility[i]));
                ++count;
            }
        }
        // Where walls meet, a picture's pixel may see past them: one direction of 64 gives 1/16.
        EXPECT_LT(sum / count, 0.003);
        EXPECT_LT(most, 0.13);
    }
}

TEST_P(BakeAccuracyGLTest, StretchCorrectionIsWhatMakesPolesRight) {
    const UvMesh sphere = uvShape("uv-sphere");
    const BakedMap open = truthOf(sphere, 64);
    ScatterOptions options;
    options.directions = 64;
    const MapErrors with = errorsOf(onlyMap(*scatter(sceneOf(sphere), options), 64), open);
    options.stretchCorrection = false;
    const BakedMap wrong = onlyMap(*scatter(sceneOf(sphere), options), 64);
    EXPECT_LT(with.inside, 0.06);
    EXPECT_GT(errorsOf(wrong, open).inside, 4.0 * with.inside);
    EXPECT_LT(wrong.visibility[64 * 3 + 32], 0.5F) << "poles have fewer points per texel";
}

TEST_P(BakeAccuracyGLTest, BentNormalsAreThoseOfRays) {
    const BakedMap truth = truthOf(shapes(), 96);
    ScatterOptions points;
    points.directions = 128;
    ShadowOptions maps;
    maps.directions = 128;
    maps.depthSize = 512;
    const MapErrors scattered = errorsOf(onlyMap(*scatter(sceneOf(shapes()), points), 96), truth);
    const MapErrors shadowed = errorsOf(onlyMap(*shadow(sceneOf(shapes()), maps), 96), truth);
    EXPECT_LT(scattered.bentAngle, 5.0);
    EXPECT_LT(shadowed.bentAngle, 5.0);
    EXPECT_LT(scattered.inside, 0.03);
    EXPECT_LT(shadowed.inside, 0.03);
}

TEST_P(BakeAccuracyGLTest, PointsMayBeOfAnySizeAndSeamsErodedOrNot) {
    const BakedMap truth = truthOf(shapes(), 64);
    for (const float size : {0.0F, 1.5F, 3.0F}) {
        ScatterOptions options;
        options.directions = 32;
        options.pointSize = size;
        EXPECT_LT(
            errorsOf(onlyMap(*scatter(sceneOf(shapes()), options), 64, 8, true), truth).inside,
            0.08)
            << size;
    }
    ScatterOptions options;
    options.directions = 32;
    options.seams = SeamFix::Erosion;
    const BakedMap eroded = onlyMap(*scatter(sceneOf(shapes()), options), 64, 2, true);
    EXPECT_LT(errorsOf(eroded, truth).inside, 0.08);
    options.normalisation = Normalisation::Brightest;
    const BakedMap brightest = onlyMap(*scatter(sceneOf(shapes()), options), 64, 2, true);
    EXPECT_EQ(*std::max_element(brightest.visibility.begin(), brightest.visibility.end()), 1.0F);
}

// Contexts share one rasteriser; what takes seconds is done in one of them.
INSTANTIATE_TEST_SUITE_P(One, BakeAccuracyGLTest, testing::Values(testContexts().front()), nameOf);

} // namespace

} // namespace aolib::bake::test
