#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "BakeScenes.h"

namespace aolib::bake::test {

namespace {

/// A map and its mipmaps, as a host would filter it.
class Mipmaps {
public:
    explicit Mipmaps(const BakedMap& map) : levels_{{map.width, map.visibility}} {
        while (levels_.back().size > 1) {
            const Level& fine = levels_.back();
            Level coarse{fine.size / 2, {}};
            for (int y = 0; y < coarse.size; ++y) {
                for (int x = 0; x < coarse.size; ++x) {
                    coarse.values.push_back(
                        0.25F * (fine.at(2 * x, 2 * y) + fine.at(2 * x + 1, 2 * y) +
                                 fine.at(2 * x, 2 * y + 1) + fine.at(2 * x + 1, 2 * y + 1)));
                }
            }
            levels_.push_back(std::move(coarse));
        }
    }

    /// The bilinear value at a level.
    float at(const glm::vec2& uv, std::size_t level) const {
        const Level& l = levels_[level];
        const glm::vec2 p = uv * float(l.size) - 0.5F;
        const glm::vec2 low = glm::floor(p);
        const glm::vec2 s = p - low;
        const int x = static_cast<int>(low.x);
        const int y = static_cast<int>(low.y);
        return (1 - s.y) * ((1 - s.x) * l.at(x, y) + s.x * l.at(x + 1, y)) +
               s.y * ((1 - s.x) * l.at(x, y + 1) + s.x * l.at(x + 1, y + 1));
    }

private:
    struct Level {
        int size;
        std::vector<float> values;
        float at(int x, int y) const {
            x = std::clamp(x, 0, size - 1);
            y = std::clamp(y, 0, size - 1);
            return values[static_cast<std::size_t>(y * size + x)];
        }
    };
    std::vector<Level> levels_;
};

/// Where the surface is one but the map is not: points along edges with two places in the map and
/// one normal.
std::vector<std::pair<glm::vec2, glm::vec2>> seamPoints(const UvMesh& mesh) {
    using Key = std::tuple<float, float, float, float, float, float>;
    const auto keyOf = [&](std::uint32_t i) {
        const glm::vec3& p = mesh.positions[i];
        const glm::vec3& n = mesh.normals[i];
        return Key(p.x, p.y, p.z, n.x, n.y, n.z);
    };
    std::map<std::pair<Key, Key>, std::pair<std::uint32_t, std::uint32_t>> edges;
    std::vector<std::pair<glm::vec2, glm::vec2>> points;
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        const std::uint32_t a = mesh.indices[i];
        const std::uint32_t b = mesh.indices[i % 3 == 2 ? i - 2 : i + 1];
        const auto other = edges.find({keyOf(b), keyOf(a)});
        if (other != edges.end()) {
            const auto [c, d] = other->second;
            if (mesh.uvs[c] != mesh.uvs[b] || mesh.uvs[d] != mesh.uvs[a]) {
                for (const float s : {0.1F, 0.37F, 0.5F, 0.81F}) {
                    points.emplace_back(glm::mix(mesh.uvs[a], mesh.uvs[b], s),
                                        glm::mix(mesh.uvs[d], mesh.uvs[c], s));
                }
            }
        }
        edges[{keyOf(a), keyOf(b)}] = {a, b};
    }
    return points;
}

TEST(SeamTest, FilteredMapsAgreeOnBothSidesOfASeam) {
    // A sphere in a corner, its first meridian half in the dark.
    UvMesh mesh;
    addUvSphere(mesh, {0.0F, 0.0F, 0.0F}, 1.0F, 64, 32, {{0.1F, 0.1F}, {0.9F, 0.9F}});
    BakeScene scene = sceneOf(mesh);
    UvMesh floor;
    addUvQuad(floor, {-9.0F, -1.05F, 9.0F}, {18, 0, 0}, {0, 0, -18}, 1);
    scene.surfaces.push_back(surfaceOf(floor, -1));
    RayOptions options;
    options.rays = 1024;
    auto baker = createRayBaker(scene, options);
    ASSERT_TRUE(baker.ok());
    const Mipmaps maps(onlyMap(**baker, 256, 8, true));
    const auto points = seamPoints(mesh);
    ASSERT_GT(points.size(), 100U);
    // Noise of 1024 rays is 0.004; at a level a texel is two, four times as large, and so is the
    // distance over which a seam's sides may look at different places.
    const std::vector<double> bounds{0.015, 0.015, 0.02, 0.03};
    for (std::size_t level = 0; level < bounds.size(); ++level) {
        double sum = 0.0;
        double most = 0.0;
        for (const auto& [one, other] : points) {
            const double step = std::abs(double(maps.at(one, level) - maps.at(other, level)));
            sum += step;
            most = std::max(most, step);
        }
        EXPECT_LT(most, bounds[level]) << "level " << level;
        EXPECT_LT(sum / double(points.size()), 0.3 * bounds[level]) << "level " << level;
    }
}

} // namespace

} // namespace aolib::bake::test
