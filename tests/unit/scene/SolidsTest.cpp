#include "scene/Solids.h"

#include <gtest/gtest.h>

namespace aolib {
namespace {

/// A box as eight vertices, facing outwards unless `insideOut`.
void addBox(std::vector<glm::vec3>& positions, std::vector<std::uint32_t>& indices,
            const glm::vec3& min, const glm::vec3& max, bool insideOut = false) {
    const auto base = static_cast<std::uint32_t>(positions.size());
    for (int i = 0; i < 8; ++i) {
        positions.emplace_back((i & 1) != 0 ? max.x : min.x, (i & 2) != 0 ? max.y : min.y,
                               (i & 4) != 0 ? max.z : min.z);
    }
    const std::uint32_t box[] = {0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5, 0, 1, 5, 0, 5, 4,
                                 2, 6, 7, 2, 7, 3, 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6};
    for (std::size_t t = 0; t < std::size(box); t += 3) {
        indices.push_back(base + box[t]);
        indices.push_back(base + box[t + (insideOut ? 2 : 1)]);
        indices.push_back(base + box[t + (insideOut ? 1 : 2)]);
    }
}

class SolidsTest : public testing::Test {
protected:
    std::vector<glm::vec3> positions;
    std::vector<std::uint32_t> indices;

    Mesh mesh() const { return *makeMesh({positions, {}, indices}); }
};

TEST_F(SolidsTest, ABoxIsASolid) {
    addBox(positions, indices, {-1, -1, -1}, {1, 1, 1});
    const Solids solids = findSolids(mesh());
    EXPECT_EQ(solids.count(), 1U);
    EXPECT_FALSE(solids.openMesh);
    EXPECT_EQ(solids.solidOfVertex, std::vector<std::uint32_t>(8, 1U));
    EXPECT_EQ(solids.indices, indices) << "it faced outwards already";
    EXPECT_EQ(solids.bounds[0].max, glm::vec3(1, 1, 1));
}

TEST_F(SolidsTest, AnInsideOutBoxIsTurned) {
    addBox(positions, indices, {4, 4, 4}, {5, 5, 5});
    const std::vector<std::uint32_t> outwards = indices;
    positions.clear();
    indices.clear();
    addBox(positions, indices, {4, 4, 4}, {5, 5, 5}, true);
    EXPECT_EQ(findSolids(mesh()).indices, outwards);
}

TEST_F(SolidsTest, ABoxWithoutALidIsAnOpenMesh) {
    addBox(positions, indices, {-1, -1, -1}, {1, 1, 1});
    indices.resize(indices.size() - 3);
    const Solids solids = findSolids(mesh());
    EXPECT_TRUE(solids.bounds.empty());
    EXPECT_EQ(solids.count(), 1U) << "the number of its open mesh";
    EXPECT_EQ(solids.solidOfVertex, std::vector<std::uint32_t>(8, Solids::kOpenMesh + 1U));
}

TEST_F(SolidsTest, SplitVerticesAreWelded) {
    addBox(positions, indices, {-1, -1, -1}, {1, 1, 1});
    std::vector<glm::vec3> split;
    for (std::uint32_t& index : indices) {
        split.push_back(positions[index]);
        index = static_cast<std::uint32_t>(split.size() - 1);
    }
    positions = split;
    EXPECT_EQ(findSolids(mesh()).count(), 1U);
}

TEST_F(SolidsTest, ComponentsAreJudgedApart) {
    addBox(positions, indices, {-1, -1, -1}, {1, 1, 1});
    addBox(positions, indices, {3, -1, -1}, {5, 1, 1});
    indices.resize(indices.size() - 3); // the second one is open
    addBox(positions, indices, {7, -1, -1}, {9, 1, 1});
    const Solids solids = findSolids(mesh());
    EXPECT_EQ(solids.bounds.size(), 2U);
    EXPECT_EQ(solids.count(), 3U);
    EXPECT_EQ(solids.solidOfVertex[0], 1U);
    EXPECT_EQ(solids.solidOfVertex[8], Solids::kOpenMesh + 3U);
    EXPECT_EQ(solids.solidOfVertex[16], 2U);
}

TEST_F(SolidsTest, TrianglesWithoutAreaDoNoHarm) {
    addBox(positions, indices, {-1, -1, -1}, {1, 1, 1});
    indices.insert(indices.end(), {0, 0, 1, 2, 2, 2});
    EXPECT_EQ(findSolids(mesh()).count(), 1U);
}

TEST_F(SolidsTest, KnowsWhichSolidsContainAPoint) {
    addBox(positions, indices, {-4, -4, -4}, {4, 4, 4});
    addBox(positions, indices, {-1, -1, -1}, {1, 1, 1});
    addBox(positions, indices, {6, -1, -1}, {8, 1, 1});
    const Mesh m = mesh();
    const Solids solids = findSolids(m);
    using Numbers = std::vector<std::uint32_t>;
    EXPECT_EQ(enclosingSolids(m, solids, {0, 0, 0}), (Numbers{0, 1}));
    EXPECT_EQ(enclosingSolids(m, solids, {2, 0, 0}), (Numbers{0}));
    EXPECT_EQ(enclosingSolids(m, solids, {5, 0, 0}), (Numbers{}));
    EXPECT_EQ(enclosingSolids(m, solids, {7, 0.3F, 0.2F}), (Numbers{2}));
}

} // namespace
} // namespace aolib
