#include "bench/bake/MapErrors.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace aolib::bench {

namespace {

/// A map of 5 by 5 texels inside a chart that fills it, all of W 0.5 and looking up.
bake::BakedMap plain() {
    bake::BakedMap map;
    map.width = 5;
    map.height = 5;
    map.visibility.assign(25, 0.5F);
    map.bentNormal.assign(25, glm::vec3(0.0F, 1.0F, 0.0F));
    map.kind.assign(25, bake::TexelKind::Inside);
    return map;
}

TEST(MapErrorsTest, EqualMapsHaveNone) {
    const MapErrors none = errorsOf(plain(), plain());
    EXPECT_EQ(none.inside, 0.0);
    EXPECT_EQ(none.seams, 0.0);
    EXPECT_EQ(none.bentAngle, 0.0);
    EXPECT_EQ(none.compared, 25);
}

TEST(MapErrorsTest, SeamsAreBordersAndWhatLiesBesideThem) {
    bake::BakedMap truth = plain();
    truth.kind[0] = bake::TexelKind::Border; // itself and three neighbours: four at the seam
    truth.kind[24] = bake::TexelKind::Empty; // not compared; three neighbours
    bake::BakedMap map = plain();
    map.visibility[0] = 0.9F;
    map.visibility[12] = 0.1F;
    map.visibility[24] = 0.0F;
    const MapErrors errors = errorsOf(map, truth);
    EXPECT_NEAR(errors.seams, 0.4 / std::sqrt(7.0), 1e-6);
    EXPECT_NEAR(errors.inside, 0.4 / std::sqrt(17.0), 1e-6);
    EXPECT_NEAR(errors.bias, -0.4 / 17.0, 1e-6);
    EXPECT_EQ(errors.compared, 24);
}

TEST(MapErrorsTest, BentNormalsCountWhereSomethingIsOpenAndNotAll) {
    bake::BakedMap truth = plain();
    truth.visibility.assign(25, 0.95F);
    truth.visibility[3] = 0.5F;
    bake::BakedMap map = truth;
    map.bentNormal.assign(25, glm::vec3(1.0F, 0.0F, 0.0F));
    map.bentNormal[3] = glm::vec3(std::sin(0.1F), std::cos(0.1F), 0.0F);
    EXPECT_NEAR(errorsOf(map, truth).bentAngle, 0.1 * 180.0 / std::numbers::pi, 1e-3);
}

TEST(MapErrorsTest, TexelsWhoseTruthIsNotKnownAreNotCompared) {
    bake::BakedMap truth = plain();
    truth.visibility[12] = -1.0F;
    bake::BakedMap map = plain();
    map.visibility[12] = 1.0F;
    map.visibility[13] = 0.6F;
    const MapErrors errors = errorsOf(map, truth);
    EXPECT_EQ(errors.compared, 24);
    EXPECT_NEAR(errors.inside, 0.1 / std::sqrt(24.0), 1e-6);
}

TEST(MapErrorsTest, SampledTexelsAreAllAtSeamsAndSoManyOthers) {
    bake::BakedMap map = plain();
    map.kind[0] = bake::TexelKind::Border;
    map.kind[24] = bake::TexelKind::Empty;
    const std::vector<std::uint8_t> wanted = sampledTexels(map, 6);
    for (const int seam : {0, 1, 5, 6, 18, 19, 23}) {
        EXPECT_EQ(wanted[static_cast<std::size_t>(seam)], 1) << seam;
    }
    EXPECT_EQ(wanted[24], 0);
    EXPECT_EQ(std::count(wanted.begin(), wanted.end(), std::uint8_t{1}), 7 + 6);
    const std::vector<std::uint8_t> all = sampledTexels(map, 1000);
    EXPECT_EQ(std::count(all.begin(), all.end(), std::uint8_t{1}), 24);
}

} // namespace

} // namespace aolib::bench
