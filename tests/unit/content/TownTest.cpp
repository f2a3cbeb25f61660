#include <algorithm>
#include <cmath>
#include <string>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "Proximity.h"
#include "Watertight.h"
#include "content/generated/GeneratedScenes.h"

namespace aolib {
namespace {

bool endsWith(const std::string& text, const std::string& ending) {
    return text.size() >= ending.size() &&
           text.compare(text.size() - ending.size(), ending.size(), ending) == 0;
}

TEST(TownTest, EverythingButGroundAndPanesIsWatertight) {
    std::size_t houses = 0;
    for (const ModelMesh& mesh : buildTown().meshes) {
        if (mesh.name == "ground" || endsWith(mesh.name, "panes")) {
            continue;
        }
        houses += endsWith(mesh.name, "walls") ? 1 : 0;
        EXPECT_EQ(test::unbalancedEdges(mesh), 0U) << mesh.name;
        EXPECT_GT(test::signedVolume(mesh), 0.0) << mesh.name;
    }
    EXPECT_GT(houses, 30U);
}

TEST(TownTest, FillsItsGroundAndStandsOnIt) {
    const Model town = buildTown();
    const Bounds bounds = town.bounds();
    EXPECT_EQ(bounds.max.x - bounds.min.x, 200.0F);
    EXPECT_EQ(bounds.max.z - bounds.min.z, 200.0F);
    EXPECT_EQ(town.meshes.front().name, "ground");
    for (const glm::vec3& p : town.meshes.front().positions) {
        EXPECT_EQ(p.y, 0.0F);
    }
    EXPECT_GT(bounds.min.y, -0.5F);
}

TEST(TownTest, TheWalkKeepsHalfAUnitFromEverySurface) {
    const TriangleMesh mesh = buildTown().flattened();
    const std::vector<glm::vec3> walk = townWalk();
    ASSERT_GT(walk.size(), 10U);
    constexpr float spacing = 0.2F;
    constexpr float clearance = 0.5F + 0.5F * spacing; // holds between the samples too
    for (std::size_t i = 0; i + 1 < walk.size(); ++i) {
        EXPECT_EQ(walk[i].y, 1.7F);
        const float length = glm::distance(walk[i], walk[i + 1]);
        const int steps = static_cast<int>(std::ceil(length / spacing));
        float nearest = clearance;
        for (int k = 0; k <= steps; ++k) {
            const float t = static_cast<float>(k) / static_cast<float>(steps);
            const glm::vec3 eye = walk[i] + t * (walk[i + 1] - walk[i]);
            nearest = std::min(nearest, test::distanceToSurface(mesh, eye, clearance));
        }
        EXPECT_EQ(nearest, clearance) << "between corners " << i << " and " << i + 1;
    }
}

} // namespace
} // namespace aolib
