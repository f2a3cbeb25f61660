#include "bench/bake/MapErrors.h"

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

} // namespace

} // namespace aolib::bench
