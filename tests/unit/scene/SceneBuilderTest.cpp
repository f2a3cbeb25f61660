#include "scene/SceneBuilder.h"

#include <limits>

#include <gtest/gtest.h>

namespace aolib {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

void giveTriangle(SceneBuilder& builder) {
    EXPECT_TRUE(builder.vertex({0.0F, 0.0F, 0.0F}).ok());
    EXPECT_TRUE(builder.vertex({1.0F, 0.0F, 0.0F}).ok());
    EXPECT_TRUE(builder.vertex({0.0F, 1.0F, 0.0F}).ok());
}

void giveRun(SceneBuilder& builder, AoPrimitive primitive, std::initializer_list<unsigned> run) {
    EXPECT_TRUE(builder.beginRun(primitive).ok());
    for (const unsigned index : run) {
        EXPECT_TRUE(builder.index(index).ok());
    }
    EXPECT_TRUE(builder.endRun().ok());
}

TEST(SceneBuilderTest, BuildsTheSquareOfTheThesis) {
    SceneBuilder builder;
    ASSERT_TRUE(builder.begin().ok());
    giveTriangle(builder);
    EXPECT_TRUE(builder.vertex({1.0F, 1.0F, 0.0F}).ok());
    giveRun(builder, AO_TRIANGLES, {0, 1, 2});
    giveRun(builder, AO_TRIANGLE_STRIP, {1, 3, 2});
    const Result<Mesh> mesh = builder.end();
    ASSERT_TRUE(mesh.ok()) << mesh.status().message();
    EXPECT_EQ(mesh->positions.size(), 4U);
    EXPECT_TRUE(mesh->normals.empty());
    EXPECT_EQ(mesh->indices, (std::vector<std::uint32_t>{0, 1, 2, 1, 3, 2}));
    EXPECT_EQ(mesh->modelBounds.max, glm::vec3(1.0F, 1.0F, 0.0F));
}

TEST(SceneBuilderTest, NormalHoldsForTheVerticesThatFollow) {
    SceneBuilder builder;
    ASSERT_TRUE(builder.begin().ok());
    EXPECT_TRUE(builder.normal({0.0F, 0.0F, 1.0F}).ok());
    EXPECT_TRUE(builder.vertex({0.0F, 0.0F, 0.0F}).ok());
    EXPECT_TRUE(builder.vertex({1.0F, 0.0F, 0.0F}).ok());
    EXPECT_TRUE(builder.normal({0.0F, 1.0F, 0.0F}).ok());
    EXPECT_TRUE(builder.vertex({0.0F, 1.0F, 0.0F}).ok());
    giveRun(builder, AO_TRIANGLES, {0, 1, 2});
    const Result<Mesh> mesh = builder.end();
    ASSERT_TRUE(mesh.ok());
    EXPECT_EQ(mesh->normals, (std::vector<glm::vec3>{{0, 0, 1}, {0, 0, 1}, {0, 1, 0}}));
}

TEST(SceneBuilderTest, CallsOutOfOrderAreRefusedAndChangeNothing) {
    SceneBuilder builder;
    EXPECT_EQ(builder.vertex({}).code(), StatusCode::InvalidCallOrder);
    EXPECT_EQ(builder.normal({}).code(), StatusCode::InvalidCallOrder);
    EXPECT_EQ(builder.beginRun(AO_QUADS).code(), StatusCode::InvalidCallOrder);
    EXPECT_EQ(builder.index(0).code(), StatusCode::InvalidCallOrder);
    EXPECT_EQ(builder.endRun().code(), StatusCode::InvalidCallOrder);
    EXPECT_EQ(builder.end().status().code(), StatusCode::InvalidCallOrder);

    ASSERT_TRUE(builder.begin().ok());
    giveTriangle(builder);
    EXPECT_EQ(builder.begin().code(), StatusCode::InvalidCallOrder);
    EXPECT_EQ(builder.index(0).code(), StatusCode::InvalidCallOrder);
    EXPECT_EQ(builder.endRun().code(), StatusCode::InvalidCallOrder);
    EXPECT_EQ(builder.normal({0, 0, 1}).code(), StatusCode::InvalidCallOrder)
        << "the vertices before would have no normal";

    ASSERT_TRUE(builder.beginRun(AO_TRIANGLES).ok());
    EXPECT_EQ(builder.beginRun(AO_TRIANGLES).code(), StatusCode::InvalidCallOrder);
    EXPECT_EQ(builder.vertex({}).code(), StatusCode::InvalidCallOrder);
    EXPECT_EQ(builder.end().status().code(), StatusCode::InvalidCallOrder);
    for (const unsigned index : {0U, 1U, 2U}) {
        EXPECT_TRUE(builder.index(index).ok());
    }
    EXPECT_TRUE(builder.endRun().ok());
    const Result<Mesh> mesh = builder.end();
    ASSERT_TRUE(mesh.ok()) << "refused calls must not have harmed the mesh";
    EXPECT_EQ(mesh->positions.size(), 3U);
    EXPECT_EQ(mesh->indices.size(), 3U);
}

TEST(SceneBuilderTest, InvalidDataDropsTheMeshWithItsOwnCode) {
    const auto endAfter = [](auto&& fault, StatusCode code) {
        SceneBuilder builder;
        ASSERT_TRUE(builder.begin().ok());
        giveTriangle(builder);
        EXPECT_EQ(fault(builder).code(), code);
        if (code == StatusCode::InvalidIndex) {
            EXPECT_EQ(builder.endRun().code(), StatusCode::Ok);
        }
        giveRun(builder, AO_TRIANGLES, {0, 1, 2});
        EXPECT_EQ(builder.end().status().code(), code);
        // The next mesh starts afresh.
        ASSERT_TRUE(builder.begin().ok());
        giveTriangle(builder);
        giveRun(builder, AO_TRIANGLES, {0, 1, 2});
        EXPECT_TRUE(builder.end().ok());
    };
    endAfter(
        [](SceneBuilder& b) {
            return b.vertex({kNaN, 0.0F, 0.0F});
        },
        StatusCode::InvalidPosition);
    endAfter(
        [](SceneBuilder& b) {
            return b.vertex({0.0F, -kInfinity, 0.0F});
        },
        StatusCode::InvalidPosition);
    endAfter(
        [](SceneBuilder& b) {
            EXPECT_TRUE(b.beginRun(AO_TRIANGLES).ok());
            return b.index(3);
        },
        StatusCode::InvalidIndex);
    endAfter(
        [](SceneBuilder& b) {
            EXPECT_TRUE(b.beginRun(AO_TRIANGLES).ok());
            EXPECT_TRUE(b.index(0).ok());
            return b.endRun();
        },
        StatusCode::IncompletePrimitive);
}

TEST(SceneBuilderTest, NaNNormalDropsTheMesh) {
    SceneBuilder builder;
    ASSERT_TRUE(builder.begin().ok());
    EXPECT_EQ(builder.normal({kNaN, 0.0F, 0.0F}).code(), StatusCode::InvalidNormal);
    giveTriangle(builder);
    giveRun(builder, AO_TRIANGLES, {0, 1, 2});
    EXPECT_EQ(builder.end().status().code(), StatusCode::InvalidNormal);
}

TEST(SceneBuilderTest, MeshWithoutTrianglesIsEmpty) {
    SceneBuilder builder;
    ASSERT_TRUE(builder.begin().ok());
    EXPECT_EQ(builder.end().status().code(), StatusCode::EmptyMesh);
    ASSERT_TRUE(builder.begin().ok());
    giveTriangle(builder);
    EXPECT_EQ(builder.end().status().code(), StatusCode::EmptyMesh);
}

TEST(SceneBuilderTest, UnknownPrimitiveIsRefusedAndTheMeshGoesOn) {
    SceneBuilder builder;
    ASSERT_TRUE(builder.begin().ok());
    giveTriangle(builder);
    EXPECT_EQ(builder.beginRun(static_cast<AoPrimitive>(99)).code(), StatusCode::InvalidPrimitive);
    giveRun(builder, AO_TRIANGLES, {0, 1, 2});
    EXPECT_TRUE(builder.end().ok());
}

TEST(SceneBuilderTest, ZeroAreaTrianglesAreAccepted) {
    SceneBuilder builder;
    ASSERT_TRUE(builder.begin().ok());
    giveTriangle(builder);
    giveRun(builder, AO_TRIANGLES, {0, 0, 0, 1, 1, 2, 0, 1, 2});
    EXPECT_TRUE(builder.end().ok());
}

} // namespace
} // namespace aolib
