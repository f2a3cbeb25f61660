#include <map>
#include <utility>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "content/Tessellation.h"
#include "content/generated/GeneratedScenes.h"

namespace aolib {
namespace {

double areaOf(const Model& model) {
    const TriangleMesh mesh = model.flattened();
    double area = 0.0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const glm::dvec3 a(mesh.positions[mesh.indices[i]]);
        const glm::dvec3 b(mesh.positions[mesh.indices[i + 1]]);
        const glm::dvec3 c(mesh.positions[mesh.indices[i + 2]]);
        area += 0.5 * glm::length(glm::cross(b - a, c - a));
    }
    return area;
}

TEST(TessellationTest, EdgesAreShortAndTheSurfaceIsTheSame) {
    const Model before = buildCornell();
    const float longest = 0.05F * before.bounds().diagonal();
    const Model after = tessellated(before, longest, 1000000);
    EXPECT_GT(after.triangleCount(), 10 * before.triangleCount());
    EXPECT_NEAR(areaOf(after) / areaOf(before), 1.0, 1e-5);
    for (const ModelMesh& mesh : after.meshes) {
        EXPECT_EQ(mesh.normals.size(), mesh.normals.empty() ? 0 : mesh.positions.size());
        for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
            const std::size_t next = i % 3 == 2 ? i - 2 : i + 1;
            const auto at = [&](std::size_t corner) {
                return glm::vec3(mesh.transform *
                                 glm::vec4(mesh.positions[mesh.indices[corner]], 1.0F));
            };
            ASSERT_LE(glm::distance(at(i), at(next)), longest);
        }
    }
}

TEST(TessellationTest, NeighboursStayNeighbours) {
    // Two triangles of very different size share an edge: it is split in both.
    Model model;
    ModelMesh mesh;
    mesh.positions = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {4.1F, 0.4F, 0}};
    mesh.indices = {0, 1, 2, 1, 3, 2};
    model.meshes.push_back(mesh);
    const Model after = tessellated(model, 1.0F, 100000);
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
    const std::vector<std::uint32_t>& indices = after.meshes[0].indices;
    for (std::size_t i = 0; i < indices.size(); ++i) {
        const std::size_t next = i % 3 == 2 ? i - 2 : i + 1;
        uses[std::minmax(indices[i], indices[next])] += 1;
    }
    // An edge within the outline has two triangles; one that has one lies on the outline.
    const auto onOutline = [&](std::uint32_t vertex) {
        const glm::dvec2 p(after.meshes[0].positions[vertex]);
        const auto on = [&](const glm::dvec2& a, const glm::dvec2& b) {
            return std::abs((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x)) < 1e-4;
        };
        return on({0, 0}, {4, 0}) || on({0, 0}, {0, 4}) || on({4, 0}, {4.1, 0.4}) ||
               on({4.1, 0.4}, {0, 4});
    };
    for (const auto& [edge, count] : uses) {
        EXPECT_LE(count, 2);
        if (count == 1) {
            EXPECT_TRUE(onOutline(edge.first) && onOutline(edge.second));
        }
    }
}

TEST(TessellationTest, TheLimitHolds) {
    EXPECT_LE(tessellated(buildCornell(), 1e-4F, 5000).triangleCount(), 5000U);
}

} // namespace
} // namespace aolib
