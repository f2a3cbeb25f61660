#include "scene/Flatten.h"

#include <gtest/gtest.h>

namespace aolib {
namespace {

using Indices = std::vector<std::uint32_t>;

Indices flattened(AoPrimitive primitive, const Indices& run) {
    Indices triangles;
    EXPECT_TRUE(flatten(primitive, run, triangles).ok());
    return triangles;
}

StatusCode codeOf(AoPrimitive primitive, const Indices& run) {
    Indices triangles{7, 8, 9};
    const AoStatus status = flatten(primitive, run, triangles);
    EXPECT_EQ(triangles, (Indices{7, 8, 9})) << "a refused run must append nothing";
    return status.code();
}

TEST(FlattenTest, TrianglesStayAsTheyAre) {
    EXPECT_EQ(flattened(AO_TRIANGLES, {0, 1, 2, 2, 1, 3}), (Indices{0, 1, 2, 2, 1, 3}));
}

TEST(FlattenTest, StripKeepsTheWinding) {
    EXPECT_EQ(flattened(AO_TRIANGLE_STRIP, {0, 1, 2, 3, 4}), (Indices{0, 1, 2, 2, 1, 3, 2, 3, 4}));
}

TEST(FlattenTest, FanTurnsAboutItsFirstVertex) {
    EXPECT_EQ(flattened(AO_TRIANGLE_FAN, {9, 1, 2, 3}), (Indices{9, 1, 2, 9, 2, 3}));
}

TEST(FlattenTest, QuadsSplitAlongTheirFirstDiagonal) {
    EXPECT_EQ(flattened(AO_QUADS, {0, 1, 2, 3, 4, 5, 6, 7}),
              (Indices{0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7}));
}

TEST(FlattenTest, QuadStripKeepsTheWinding) {
    // The quads of 0 1 2 3 4 5 are 0 1 3 2 and 2 3 5 4.
    EXPECT_EQ(flattened(AO_QUAD_STRIP, {0, 1, 2, 3, 4, 5}),
              (Indices{0, 1, 3, 0, 3, 2, 2, 3, 5, 2, 5, 4}));
}

TEST(FlattenTest, EmptyRunAddsNothing) {
    for (int primitive = AO_TRIANGLES; primitive <= AO_QUAD_STRIP; ++primitive) {
        EXPECT_TRUE(flattened(static_cast<AoPrimitive>(primitive), {}).empty());
    }
}

TEST(FlattenTest, IncompleteRunsAreRefused) {
    EXPECT_EQ(codeOf(AO_TRIANGLES, {0, 1}), StatusCode::IncompletePrimitive);
    EXPECT_EQ(codeOf(AO_TRIANGLES, {0, 1, 2, 3}), StatusCode::IncompletePrimitive);
    EXPECT_EQ(codeOf(AO_TRIANGLE_STRIP, {0, 1}), StatusCode::IncompletePrimitive);
    EXPECT_EQ(codeOf(AO_TRIANGLE_FAN, {0}), StatusCode::IncompletePrimitive);
    EXPECT_EQ(codeOf(AO_QUADS, {0, 1, 2}), StatusCode::IncompletePrimitive);
    EXPECT_EQ(codeOf(AO_QUAD_STRIP, {0, 1, 2, 3, 4}), StatusCode::IncompletePrimitive);
    EXPECT_EQ(codeOf(AO_QUAD_STRIP, {0, 1}), StatusCode::IncompletePrimitive);
}

TEST(FlattenTest, UnknownPrimitiveIsRefused) {
    EXPECT_EQ(codeOf(static_cast<AoPrimitive>(17), {0, 1, 2}), StatusCode::InvalidPrimitive);
}

} // namespace
} // namespace aolib
