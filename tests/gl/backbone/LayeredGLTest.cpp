// The layered-interval estimator on the GPU against closed forms, from the cube map's own texels.
#include <cmath>

#include "SmallScene.h"

namespace aolib {
namespace {

class LayeredGLTest : public GLTest {
protected:
    static Options options(Falloff falloff = Falloff::Off, float radius = 1.0F) {
        Options o = atOnce();
        o.estimator = Estimator::LayeredIntervals;
        o.falloff = falloff;
        o.radius = radius;
        o.cubeMaps.faceSize = 64;
        o.cubeMaps.place = false;
        return o;
    }

    CubeMapImage capture(const Model& model, const Options& o, const glm::vec3& centre) {
        SmallHost host(gl, loader, model, o);
        const auto id = host.ao().addCubeMap(centre);
        EXPECT_TRUE(id.ok()) << id.status().message();
        info_ = host.ao().cubeMaps().at(0);
        return *host.ao().readCubeMap(*id);
    }
    static float at(const CubeMapImage& cube, const glm::vec3& point) {
        return cube.visibility[texelTowards(cube, point)];
    }

    CubeMapInfo info_;
};

TEST_P(LayeredGLTest, ALonePlaneIsOpenEverywhere) {
    Model model;
    addQuad(model, {-50, 0, -50}, {-50, 0, 50}, {50, 0, 50}, {50, 0, -50});
    const CubeMapImage cube = capture(model, options(), {0.3F, 1.0F, 0.2F});
    EXPECT_EQ(info_.layers, 1) << "one surface along each ray needs one layer";
    for (std::size_t i = 0; i < cube.visibility.size(); ++i) {
        ASSERT_EQ(cube.visibility[i], 1.0F) << "texel " << i;
    }
}

TEST_P(LayeredGLTest, AClosedRoomIsClosedWithoutASeam) {
    Model model;
    addBox(model, {-2, -1, -3}, {2, 1.5F, 3});
    const CubeMapImage cube = capture(model, options(), {0.4F, 0.1F, -0.3F});
    for (std::size_t i = 0; i < cube.visibility.size(); ++i) {
        // A gap of one sector of one slice: measured at most 0.008.
        ASSERT_LE(cube.visibility[i], 0.012F) << "texel " << i;
    }
}

TEST_P(LayeredGLTest, AFloorBesideAWall) {
    Model model;
    addQuad(model, {0, 0, -60}, {0, 0, 60}, {60, 0, 60}, {60, 0, -60});
    addBox(model, {-1, 0, -60}, {0, 2, 60});
    const CubeMapImage cube = capture(model, options(), {1.5F, 3.0F, 0.1F});
    for (const float d : {0.5F, 1.0F, 2.0F}) {
        // Occlusion (1 - d / sqrt(d^2 + h^2)) / 2 of a long wall of height 2. The topmost sample of
        // the wall stands for half a step beyond its edge: measured 0.018 too dark with texels this
        // coarse.
        EXPECT_NEAR(at(cube, {d, 0, 0.1F}), 1 - (1 - d / std::sqrt(d * d + 4)) / 2, 0.025F) << d;
    }
}

TEST_P(LayeredGLTest, WhatIsHiddenFromTheCentreOccludes) {
    // A slab floats over the floor; the centre is above it and sees none of its underside.
    Model model;
    addQuad(model, {-20, 0, -20}, {-20, 0, 20}, {20, 0, 20}, {20, 0, -20});
    addBox(model, {-3, 1.0F, -3}, {3, 1.2F, 3});
    const CubeMapImage cube = capture(model, options(Falloff::Step, 3.0F), {7, 4, 0});
    EXPECT_GE(info_.layers, 2);
    EXPECT_LT(at(cube, {2.6F, 0, 0}), 0.75F) << "under the edge of the slab";
    EXPECT_GT(at(cube, {9, 0, 0}), 0.97F) << "beyond its reach";
    Options one = options(Falloff::Step, 3.0F);
    one.layeredIntervals.layers = 1;
    const CubeMapImage shallow = capture(model, one, {7, 4, 0});
    EXPECT_EQ(info_.layers, 1);
}

TEST_P(LayeredGLTest, WallsTurnedInsideOutChangeNothing) {
    Model outward;
    addQuad(outward, {-20, 0, -20}, {-20, 0, 20}, {20, 0, 20}, {20, 0, -20});
    addBox(outward, {-1, 0, -1}, {1, 2, 1});
    Model inward = outward;
    std::vector<std::uint32_t>& indices = inward.meshes.back().indices;
    for (std::size_t t = 0; t < indices.size(); t += 3) {
        std::swap(indices[t + 1], indices[t + 2]);
    }
    const Options o = options(Falloff::Step, 2.0F);
    EXPECT_EQ(capture(outward, o, {3, 3, 2}).visibility, capture(inward, o, {3, 3, 2}).visibility);
}

TEST_P(LayeredGLTest, AHouseWithoutABottomOccludesAsAClosedOneDoes) {
    Model closed;
    addQuad(closed, {-20, 0, -20}, {-20, 0, 20}, {20, 0, 20}, {20, 0, -20});
    addBox(closed, {-1, 0.01F, -1}, {1, 2, 1});
    Model open = closed;
    // The two triangles of the box that face downwards go.
    ModelMesh& box = open.meshes.back();
    std::vector<std::uint32_t> kept;
    for (std::size_t t = 0; t < box.indices.size(); t += 3) {
        const auto height = [&](std::size_t k) { return box.positions[box.indices[t + k]].y; };
        if (height(0) + height(1) + height(2) > 0.1F) {
            kept.insert(kept.end(), &box.indices[t], &box.indices[t] + 3);
        }
    }
    ASSERT_EQ(kept.size(), box.indices.size() - 6);
    box.indices = kept;
    const Options o = options(Falloff::Step, 2.0F);
    const CubeMapImage a = capture(closed, o, {3, 3, 2});
    const CubeMapImage b = capture(open, o, {3, 3, 2});
    for (std::size_t i = 0; i < a.visibility.size(); ++i) {
        // A sector of one slice: the roof's solid now ends at the floor.
        ASSERT_NEAR(a.visibility[i], b.visibility[i], 2.5F / 255.0F) << "texel " << i;
    }
}

TEST_P(LayeredGLTest, AnOpenRoomIsClosedWhicheverWayItsWallsAreTurned) {
    Model outward;
    addBox(outward, {-2, -1, -3}, {2, 1.5F, 3});
    std::vector<std::uint32_t>& indices = outward.meshes.back().indices;
    indices.resize(indices.size() - 3); // no solid any more
    Model inward = outward;
    std::vector<std::uint32_t>& turned = inward.meshes.back().indices;
    for (std::size_t t = 0; t < turned.size(); t += 3) {
        std::swap(turned[t + 1], turned[t + 2]);
    }
    const Options o = options(Falloff::Step, 1.0F);
    const glm::vec3 centre{0.4F, 0.1F, -0.3F};
    const CubeMapImage backs = capture(outward, o, centre);
    const CubeMapImage fronts = capture(inward, o, centre);
    for (std::size_t i = 0; i < backs.visibility.size(); ++i) {
        // Rounding: vertices come in another order.
        ASSERT_NEAR(backs.visibility[i], fronts.visibility[i], 2.5F / 255.0F) << "texel " << i;
    }
    // Its corners are as dark as those of a closed room.
    Model closed;
    addBox(closed, {-2, -1, -3}, {2, 1.5F, 3});
    const glm::vec3 corner{-1.9F, -0.9F, -2.9F};
    EXPECT_NEAR(at(backs, corner), at(capture(closed, o, centre), corner), 0.01F);
}

TEST_P(LayeredGLTest, LeavesHaveNoThickness) {
    // Two upright leaves before a far wall, their fronts or one back and one front towards the
    // centre: once a back shows, the mesh is no hull, and neither leaf has anything behind it.
    const auto scene = [](bool turned) {
        Model model;
        addQuad(model, {-20, 0, -20}, {-20, 0, 20}, {20, 0, 20}, {20, 0, -20});
        addQuad(model, {-3, 0.5F, 0}, {-1, 0.5F, 0}, {-1, 4, 0}, {-3, 4, 0});
        ModelMesh& leaves = model.meshes.back();
        for (const std::uint32_t i : {0U, 1U, 2U, 3U}) {
            leaves.positions.push_back(leaves.positions[i] + glm::vec3(4, 0, 0));
        }
        if (turned) {
            leaves.indices.insert(leaves.indices.end(), {4, 6, 5, 4, 7, 6});
        } else {
            leaves.indices.insert(leaves.indices.end(), {4, 5, 6, 4, 6, 7});
        }
        return model;
    };
    const Options o = options(Falloff::Step, 3.0F);
    const CubeMapImage hulls = capture(scene(false), o, {0, 2, 6});
    const CubeMapImage leaves = capture(scene(true), o, {0, 2, 6});
    // Seen between the leaves, on the floor behind them.
    const glm::vec3 behind{0, 0, -1.5F};
    EXPECT_GT(at(leaves, behind), at(hulls, behind) + 0.05F);
    EXPECT_GT(at(leaves, behind), 0.85F);
}

TEST_P(LayeredGLTest, ResultsStayFiniteAndInRange) {
    for (const Falloff falloff : {Falloff::Step, Falloff::Exp, Falloff::Off}) {
        Model model;
        addBox(model, {-2, -1, -3}, {2, 1.5F, 3});
        addBox(model, {0.5F, -1, -1}, {1, 0, -0.5F});
        addQuad(model, {-1, 0, -2}, {-1, 0, -2}, {-1, 1, -2}, {-1, 1, -2}); // no area
        const CubeMapImage cube = capture(model, options(falloff, 0.7F), {0.4F, 0.1F, 0.6F});
        for (const float w : cube.visibility) {
            ASSERT_TRUE(std::isfinite(w) && w >= 0.0F && w <= 1.0F);
        }
    }
}

AOLIB_FOR_ALL_CONTEXTS(LayeredGLTest);

} // namespace
} // namespace aolib
