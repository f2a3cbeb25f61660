#include "bake/scatter/ThinTexels.h"

#include <gtest/gtest.h>

namespace aolib::bake::test {

namespace {

/// Three texels in a row, W (times coverage) as the light's weight.
struct Row {
    std::vector<glm::vec4> light;
    std::vector<float> coverage;
    std::vector<float> facets;

    void add(float w, float covered, float facet) {
        light.emplace_back(0.0F, w * covered, 0.0F, w * covered);
        coverage.push_back(covered);
        facets.push_back(facet);
    }
    float at(std::size_t texel) const {
        return lightPerCoverage({{static_cast<int>(light.size()), 1}, light, coverage, facets},
                                texel)
            .w;
    }
};

TEST(ThinTexelsTest, WhatIsCoveredWellStaysByItself) {
    Row row;
    row.add(1.0F, 1.0F, 1.0F);
    row.add(0.5F, 0.4F, 1.0F);
    row.add(0.0F, 1.0F, 1.0F);
    EXPECT_FLOAT_EQ(row.at(0), 1.0F);
    EXPECT_FLOAT_EQ(row.at(1), 0.5F);
    EXPECT_FLOAT_EQ(row.at(2), 0.0F);
}

TEST(ThinTexelsTest, ThinOnesAreHelpedByTheirOwnFacetOnly) {
    Row row;
    row.add(0.0F, 1.0F, 2.0F);
    row.add(0.0F, 0.05F, 1.0F);
    row.add(1.0F, 1.0F, 1.0F);
    // Of 0.15 that are wanted a tenth is taken from the right, nothing from the left.
    EXPECT_NEAR(row.at(1), 0.1F / 0.15F, 1e-5F);
    row.coverage[1] = 0.0F;
    row.light[1] = glm::vec4(0.0F);
    EXPECT_NEAR(row.at(1), 1.0F, 1e-5F) << "where no point fell at all";
}

TEST(ThinTexelsTest, NothingComesOfNothing) {
    Row row;
    row.add(1.0F, 1.0F, 2.0F);
    row.add(0.0F, 0.0F, 1.0F);
    EXPECT_EQ(row.at(1), 0.0F);
}

} // namespace

} // namespace aolib::bake::test
