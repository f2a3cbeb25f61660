#include "app/ParseValues.h"

#include <gtest/gtest.h>

#include "app/Table.h"

namespace aolib::app {

namespace {

TEST(ParseValuesTest, NumbersAreFiniteAndNothingElse) {
    EXPECT_EQ(parseNumber("1.5"), 1.5);
    EXPECT_EQ(parseNumber("-2e3"), -2000.0);
    EXPECT_EQ(parseNumber("+7"), 7.0);
    for (const char* text : {"", " 1", "1 ", "1x", "nan", "inf", "-inf", "1e999", "0x10", "+-1"}) {
        EXPECT_FALSE(parseNumber(text)) << text;
    }
}

TEST(ParseValuesTest, VectorsHaveThreeNumbers) {
    EXPECT_EQ(parseVector("1,-2.5,3e1"), glm::vec3(1.0F, -2.5F, 30.0F));
    for (const char* text : {"", "1", "1,2", "1,2,", "1,2,3,", "1,2,3,4", "1,,3", "1e39,0,0"}) {
        EXPECT_FALSE(parseVector(text)) << text;
    }
}

TEST(ParseValuesTest, LengthsMayBeShares) {
    ASSERT_TRUE(parseLength("10%"));
    EXPECT_DOUBLE_EQ(parseLength("10%")->resolved(50.0), 5.0);
    EXPECT_DOUBLE_EQ(parseLength("0.3")->resolved(50.0), 0.3);
    for (const char* text : {"", "%", "-1", "-1%", "1%%", "nan%"}) {
        EXPECT_FALSE(parseLength(text)) << text;
    }
}

TEST(TableTest, AlignsColumns) {
    Table table({"scene", "triangles"});
    table.add({"a", grouped(1234567)});
    table.add({"longer", grouped(12)});
    EXPECT_EQ(table.text(), "scene   triangles\n"
                            "a       1 234 567\n"
                            "longer         12\n");
}

TEST(TableTest, WhatIsNotKnownIsADash) {
    EXPECT_EQ(knownNumber(-1.0, 2), "-");
    EXPECT_EQ(knownNumber(2.345, 1), "2.3");
    EXPECT_EQ(knownPercentage(-1.0), "-");
    EXPECT_EQ(knownPercentage(0.5), "50.0%");
}

} // namespace

} // namespace aolib::app
