#include "bake/maps/MapFill.h"

#include <gtest/gtest.h>

#include "BakeScenes.h"

namespace aolib::bake::test {

namespace {

/// A map of values, -1 where there is none.
BakedMap mapOf(int width, std::vector<float> values) {
    BakedMap map;
    map.width = width;
    map.height = static_cast<int>(values.size()) / width;
    map.bentNormal.assign(values.size(), glm::vec3(0.0F));
    for (std::size_t i = 0; i < values.size(); ++i) {
        map.bentNormal[i] = glm::vec3(0.0F, 0.0F, values[i] < 0.0F ? 0.0F : 1.0F);
    }
    map.kind.assign(values.size(), TexelKind::Inside);
    map.visibility = std::move(values);
    return map;
}

TEST(MapFillTest, ErosionTakesTheOuterTexelsOnly) {
    BakedMap map = mapOf(5, {-1, 1, 1, 1, 1, //
                             1, 1, 1, 1, 1,  //
                             1, 1, 1, 1, 1});
    erode(map);
    // The borders of the map itself are no borders of a chart.
    EXPECT_EQ(map.visibility, (std::vector<float>{-1, -1, 1, 1, 1, //
                                                  -1, -1, 1, 1, 1, //
                                                  1, 1, 1, 1, 1}));
    EXPECT_EQ(map.bentNormal[1], glm::vec3(0.0F));
}

TEST(MapFillTest, DilationTakesMeansStepByStep) {
    BakedMap map = mapOf(5, {0.25F, 0.75F, -1, -1, -1});
    dilate(map, 1);
    EXPECT_EQ(map.visibility, (std::vector<float>{0.25F, 0.75F, 0.75F, -1, -1}));
    dilate(map, 5);
    EXPECT_EQ(map.visibility, (std::vector<float>{0.25F, 0.75F, 0.75F, 0.75F, 0.75F}));
    EXPECT_EQ(map.bentNormal[4], glm::vec3(0, 0, 1));
    BakedMap between = mapOf(3, {0.0F, -1, 1.0F});
    dilate(between, 1);
    EXPECT_EQ(between.visibility[1], 0.5F);
}

TEST(MapFillTest, TheRestIsTheMeanOfTheSmallestBlockWithValues) {
    BakedMap map = mapOf(4, {0.2F, 0.4F, -1, -1, //
                             -1, -1, -1, -1,     //
                             -1, -1, -1, -1,     //
                             -1, -1, -1, 0.9F});
    fillRest(map);
    EXPECT_FLOAT_EQ(map.visibility[4], 0.3F);  // its own block of two by two
    EXPECT_FLOAT_EQ(map.visibility[2], 0.5F);  // only the block of four by four has values
    EXPECT_FLOAT_EQ(map.visibility[10], 0.9F); // again its own
    EXPECT_FLOAT_EQ(map.visibility[0], 0.2F);
}

TEST(MapFillTest, NothingComesOfNothing) {
    BakedMap map = mapOf(3, std::vector<float>(9, -1.0F));
    dilate(map, 3);
    fillRest(map);
    EXPECT_EQ(map.visibility, std::vector<float>(9, -1.0F));
}

} // namespace

} // namespace aolib::bake::test
