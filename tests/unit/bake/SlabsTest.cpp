#include <cmath>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "bake/gpu/SlabBins.h"
#include "bake/gpu/Slabs.h"

namespace aolib::bake {

namespace {

/// The cube from -1 to 1 from an oblique direction.
LightView view(double reach) {
    const BakeFrame frame(Bounds{glm::vec3(-1.0F), glm::vec3(1.0F)});
    LightView made = lightView(frame, {glm::dvec3(0.0), frame.halfExtent()},
                               glm::normalize(glm::dvec3(1.0, 2.0, 3.0)), 64, 0, 5);
    made.reach = reach;
    return made;
}

TEST(SlabsTest, AreAsThickAsTheReachAndHoldTheScene) {
    const LightView light = view(0.15);
    const Slabs slabs(light);
    const glm::vec3 towards(light.direction);
    const float here = slabs.coordinate(glm::vec3(0.1F));
    EXPECT_NEAR(slabs.coordinate(glm::vec3(0.1F) - 0.15F * towards), here + 1.0F, 1e-4F)
        << "away from the light";
    const float corner = 1.0F / std::sqrt(3.0F); // of the frame's box
    for (int i = 0; i < 8; ++i) {
        const glm::vec3 place((i & 1) != 0 ? corner : -corner, (i & 2) != 0 ? corner : -corner,
                              (i & 4) != 0 ? corner : -corner);
        EXPECT_GT(slabs.coordinate(place), 0.0F);
        EXPECT_LT(slabs.coordinate(place), float(slabs.count()));
    }
    EXPECT_EQ(Slabs(view(1e9)).count(), 1);
}

TEST(SlabsTest, ClipSpaceHoldsASlabFromEitherSide) {
    const Slabs slabs(view(0.15));
    const glm::vec3 place(0.1F, -0.2F, 0.05F);
    const float coordinate = slabs.coordinate(place);
    const int slab = static_cast<int>(std::floor(coordinate));
    const float within = coordinate - float(slab);
    const auto depth = [&](const glm::mat4& toClip) {
        return (toClip * glm::vec4(place, 1.0F)).z * 0.5F + 0.5F;
    };
    EXPECT_NEAR(depth(slabs.nearest(slab)), within, 1e-5F);
    EXPECT_NEAR(depth(slabs.farthest(slab)), 1.0F - within, 1e-5F);
    EXPECT_GT(depth(slabs.nearest(slab - 1)), 1.0F) << "behind that slab";
    EXPECT_LT(depth(slabs.nearest(slab + 1)), 0.0F);
}

TEST(SlabsTest, TrianglesLieInAllSlabsThatTheyTouchAndNoOthers) {
    std::vector<glm::vec3> positions;
    std::vector<std::uint32_t> indices;
    for (int i = 0; i < 300; ++i) {
        const float t = float(i) / 300.0F - 0.5F;
        positions.emplace_back(t, 0.3F * std::sin(40.0F * t), 0.3F * std::cos(70.0F * t));
        indices.push_back(static_cast<std::uint32_t>(i));
    }
    const Slabs slabs(view(0.05));
    SlabBins bins(positions, indices);
    bins.begin(slabs);
    EXPECT_EQ(bins.bin(3).count, 0U) << "not filled yet";
    std::set<std::pair<int, std::uint32_t>> found;
    for (int first = 0; first < slabs.count(); first += 7) { // in pieces
        bins.fill(first, std::min(first + 7, slabs.count()));
        EXPECT_EQ(bins.bin(first - 1).count, 0U);
        for (int slab = first; slab < std::min(first + 7, slabs.count()); ++slab) {
            const TriangleRange range = bins.bin(slab);
            for (std::size_t i = range.first; i < range.first + range.count; ++i) {
                EXPECT_TRUE(found.emplace(slab, bins.numbers()[i]).second) << "once";
                EXPECT_EQ(bins.indices()[3 * i + 2], 3 * bins.numbers()[i] + 2);
            }
        }
    }
    for (std::uint32_t triangle = 0; triangle < 100; ++triangle) {
        float low = 1e9F;
        float high = -1e9F;
        for (std::uint32_t k = 0; k < 3; ++k) {
            low = std::min(low, slabs.coordinate(positions[3 * triangle + k]));
            high = std::max(high, slabs.coordinate(positions[3 * triangle + k]));
        }
        for (int slab = 0; slab < slabs.count(); ++slab) {
            const bool touches = high > float(slab) && low < float(slab + 1);
            EXPECT_EQ(found.count({slab, triangle}), touches ? 1U : 0U) << slab << ' ' << triangle;
        }
    }
}

} // namespace

} // namespace aolib::bake
