#include <aolib/bake/Atlas.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <aolib/bake/UvReport.h>

#include "BakeScenes.h"

namespace aolib::bake::test {

namespace {

/// A ramp that winds twice about the y axis: flat enough for one chart, which would cover itself.
UvMesh spiralRamp() {
    UvMesh mesh;
    constexpr int steps = 64;
    for (int i = 0; i <= steps; ++i) {
        const float angle = 4.0F * std::numbers::pi_v<float> * float(i) / steps;
        for (const float radius : {1.0F, 2.0F}) {
            mesh.positions.emplace_back(radius * std::cos(angle), 0.1F * angle,
                                        -radius * std::sin(angle));
        }
    }
    for (std::uint32_t i = 0; i < 2 * steps; i += 2) {
        mesh.indices.insert(mesh.indices.end(), {i, i + 1, i + 3, i, i + 3, i + 2});
    }
    return mesh;
}

Surface unwrappedOf(const UvMesh& mesh, Atlas& atlas, int size = 512) {
    const Surface surface = surfaceOf(mesh);
    auto made = makeAtlas({&surface}, size, size, 4);
    EXPECT_TRUE(made.ok()) << made.status().message();
    atlas = *made;
    return withAtlas(surface, atlas.surfaces[0]);
}

class AtlasTest : public testing::TestWithParam<const char*> {
protected:
    static UvMesh mesh() {
        const std::string name = GetParam();
        return name == "ramp" ? spiralRamp() : name == "bumps" ? bumpySphere(5000) : uvShape(name);
    }
};

TEST_P(AtlasTest, NoTexelIsSharedAndNoTriangleLost) {
    Atlas atlas;
    BakeScene scene;
    scene.surfaces.push_back(unwrappedOf(mesh(), atlas));
    const UvReport report = checkUvs(scene, 0, 512, 512);
    EXPECT_EQ(report.unusable(), 0U) << report.sentence();
    EXPECT_EQ(report.overlappingTexels, 0U) << report.sentence();
    EXPECT_NEAR(atlas.usedShare, double(report.coveredTexels) / (512.0 * 512.0), 0.01);
    EXPECT_GT(atlas.usedShare, 0.2);
}

TEST_P(AtlasTest, TrianglesStayWhereAndAsLargeAsTheyWere) {
    Atlas atlas;
    const UvMesh before = mesh();
    const Surface after = unwrappedOf(before, atlas);
    ASSERT_EQ(after.indices.size(), before.indices.size());
    double least = INFINITY;
    double most = 0.0;
    for (std::size_t i = 0; i < after.indices.size(); i += 3) {
        glm::vec3 p[3];
        glm::vec2 uv[3];
        for (std::size_t k = 0; k < 3; ++k) {
            p[k] = after.positions[after.indices[i + k]];
            uv[k] = after.uvs[after.indices[i + k]];
            ASSERT_EQ(p[k], before.positions[before.indices[i + k]]);
        }
        const double space = double(glm::length(glm::cross(p[1] - p[0], p[2] - p[0])));
        const glm::vec2 a = uv[1] - uv[0];
        const glm::vec2 b = uv[2] - uv[0];
        const double map = double(std::abs(a.x * b.y - a.y * b.x));
        if (space > 1e-5) {
            least = std::min(least, map / space);
            most = std::max(most, map / space);
        }
    }
    EXPECT_LT(most / least, 1.0 / 0.70);
}

TEST_P(AtlasTest, ChartsKeepTheirDistance) {
    Atlas atlas;
    const Surface surface = unwrappedOf(mesh(), atlas, 256);
    for (const glm::vec2& uv : surface.uvs) {
        EXPECT_GE(uv.x * 256.0F, 2.0F);
        EXPECT_LE(uv.x * 256.0F, 254.0F);
        EXPECT_GE(uv.y * 256.0F, 2.0F);
        EXPECT_LE(uv.y * 256.0F, 254.0F);
    }
}

/// Per vertex a vertex of its chart, the same for all: no place in the map is two charts'.
std::vector<std::uint32_t> chartsOf(const Surface& surface) {
    std::map<std::pair<float, float>, std::uint32_t> places;
    std::vector<std::uint32_t> chart;
    for (std::uint32_t i = 0; i < surface.uvs.size(); ++i) {
        chart.push_back(places.try_emplace({surface.uvs[i].x, surface.uvs[i].y}, i).first->second);
    }
    for (bool changed = true; changed;) {
        changed = false;
        for (std::size_t i = 0; i < surface.indices.size(); i += 3) {
            std::uint32_t least = ~0U;
            for (std::size_t k = 0; k < 3; ++k) {
                least = std::min(least, chart[surface.indices[i + k]]);
            }
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint32_t other = chart[surface.indices[i + k]];
                changed = changed || other != least;
                std::replace(chart.begin(), chart.end(), other, least);
            }
        }
    }
    return chart;
}

TEST_P(AtlasTest, ATexelOfAMipmapAsWideAsTheGapHasOneChart) {
    constexpr int size = 512;
    constexpr int block = 4; // the gap
    Atlas atlas;
    const Surface surface = unwrappedOf(mesh(), atlas, size);
    const std::vector<std::uint32_t> charts = chartsOf(surface);
    std::map<std::uint32_t, std::pair<glm::vec2, glm::vec2>> boxes;
    for (std::size_t i = 0; i < charts.size(); ++i) {
        const glm::vec2 place = surface.uvs[i] * float(size);
        const auto [found, fresh] = boxes.try_emplace(charts[i], place, place);
        found->second = {glm::min(found->second.first, place),
                         glm::max(found->second.second, place)};
    }
    std::map<std::pair<int, int>, std::uint32_t> owners;
    for (const auto& [chart, box] : boxes) {
        // What bilinear filtering of that mipmap reads.
        const glm::ivec2 low(glm::floor((box.first - 0.499F * block) / float(block)));
        const glm::ivec2 high(glm::floor((box.second + 0.499F * block) / float(block)));
        for (int y = low.y; y <= high.y; ++y) {
            for (int x = low.x; x <= high.x; ++x) {
                const auto [owner, fresh] = owners.try_emplace({x, y}, chart);
                ASSERT_EQ(owner->second, chart) << x << ' ' << y;
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Shapes, AtlasTest,
                         testing::Values("uv-sphere", "uv-box", "uv-shapes", "ramp", "bumps"),
                         [](const auto& shape) {
                             std::string name = shape.param;
                             std::erase(name, '-');
                             return name;
                         });

TEST(AtlasChartsTest, ABoxHasSixChartsAndARampManyMore) {
    Atlas atlas;
    unwrappedOf(uvShape("uv-box"), atlas);
    EXPECT_EQ(atlas.charts, 6U);
    const UvMesh ramp = spiralRamp();
    unwrappedOf(ramp, atlas);
    EXPECT_EQ(atlas.charts, ramp.indices.size() / 3);
}

TEST(AtlasChartsTest, TooManyChartsAreAnErrorWithNumbers) {
    const Surface surface = surfaceOf(uvShape("uv-box"));
    const auto made = makeAtlas({&surface}, 8, 8, 4);
    EXPECT_EQ(made.status().code(), StatusCode::InvalidOption);
    EXPECT_NE(made.status().message().find("6 charts"), std::string::npos);
}

TEST(AtlasChartsTest, TrianglesWithoutAreaAreKept) {
    Surface surface = surfaceOf(unitFloor(1));
    surface.indices.insert(surface.indices.end(), {0, 0, 1});
    const auto made = makeAtlas({&surface}, 64, 64, 4);
    ASSERT_TRUE(made.ok());
    const Surface after = withAtlas(surface, made->surfaces[0]);
    ASSERT_EQ(after.indices.size(), surface.indices.size());
    EXPECT_EQ(after.positions[after.indices[8]], surface.positions[1]);
}

} // namespace

} // namespace aolib::bake::test
