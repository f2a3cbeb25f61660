// The horizon-split estimator on the GPU against closed forms, read from the cube map's own texels.
#include <cmath>

#include "SmallScene.h"

namespace aolib {
namespace {

class AnalyticGLTest : public GLTest {
protected:
    static Options exact(float radius) {
        Options options = atOnce();
        options.radius = radius;
        options.horizonSplit = {.directions = 32, .steps = 96, .stepSize = 0.0F};
        options.cubeMaps.faceSize = 128;
        options.cubeMaps.place = false;
        return options;
    }

    CubeMapImage capture(const Model& model, const Options& options, const glm::vec3& centre) {
        SmallHost host(gl, loader, model, options);
        const auto id = host.ao().addCubeMap(centre);
        EXPECT_TRUE(id.ok()) << id.status().message();
        return *host.ao().readCubeMap(*id);
    }

    /// W of the texel that sees `point`.
    static float at(const CubeMapImage& cube, const glm::vec3& point) {
        const std::size_t texel = texelTowards(cube, point);
        const float distance = glm::distance(point, cube.position);
        EXPECT_NEAR(cube.distance[texel], distance, 0.02F * distance);
        return cube.visibility[texel];
    }
};

TEST_P(AnalyticGLTest, ALonePlaneIsOpenEverywhere) {
    Model model;
    addQuad(model, {-50, 0, -50}, {-50, 0, 50}, {50, 0, 50}, {50, 0, -50});
    const CubeMapImage cube = capture(model, exact(2.0F), {0.3F, 1.0F, 0.2F});
    int seen = 0;
    for (std::size_t i = 0; i < cube.visibility.size(); ++i) {
        ASSERT_TRUE(std::isfinite(cube.visibility[i]));
        if (cube.distance[i] > 0) {
            ++seen;
            // 1 less one step of the 8 bits that are kept.
            ASSERT_GE(cube.visibility[i], 1.0F - 1.0F / 255.0F);
        }
    }
    EXPECT_GT(seen, 128 * 128) << "the whole face -Y and half of four others";
}

TEST_P(AnalyticGLTest, AFloorBesideAWall) {
    // Wall of height 2 along x = 0, floor from it; both long. Occlusion (1 - d / sqrt(d^2 + h^2))
    // / 2.
    Model model;
    addQuad(model, {0, 0, -60}, {0, 0, 60}, {60, 0, 60}, {60, 0, -60});
    addQuad(model, {0, 0, -60}, {0, 2, -60}, {0, 2, 60}, {0, 0, 60});
    Options options = exact(12.0F);
    options.falloff = Falloff::Off;
    // High above, so that floor and wall lie in one face: the estimator stops at its border.
    const CubeMapImage cube = capture(model, options, {1.5F, 6.0F, 0.1F});
    for (const float d : {0.5F, 1.0F, 2.0F}) {
        const float truth = 1 - (1 - d / std::sqrt(d * d + 4)) / 2;
        // The estimator books a sample under the azimuth of its step, though the wall's upper
        // parts, seen from above, stand in another: measured 0.049, 0.021 and 0.005.
        EXPECT_NEAR(at(cube, {d, 0, 0.1F}), truth, 0.03F / d) << "at distance " << d;
    }
}

TEST_P(AnalyticGLTest, TheInsideOfAClosedSphereIsClosed) {
    Model model;
    ModelMesh sphere;
    constexpr int kRings = 48;
    constexpr int kSegments = 96;
    for (int r = 0; r <= kRings; ++r) {
        for (int s = 0; s <= kSegments; ++s) {
            const float theta = 3.14159265F * static_cast<float>(r) / kRings;
            const float phi = 6.2831853F * static_cast<float>(s) / kSegments;
            sphere.positions.emplace_back(std::sin(theta) * std::cos(phi), std::cos(theta),
                                          std::sin(theta) * std::sin(phi));
        }
    }
    for (std::uint32_t r = 0; r < kRings; ++r) {
        for (std::uint32_t s = 0; s < kSegments; ++s) {
            const std::uint32_t a = r * (kSegments + 1) + s;
            const std::uint32_t b = a + kSegments + 1;
            sphere.indices.insert(sphere.indices.end(), {a, b, a + 1, a + 1, b, b + 1});
        }
    }
    model.meshes.push_back(sphere);
    Options options = exact(2.0F);
    options.falloff = Falloff::Off;
    const CubeMapImage cube = capture(model, options, {0, 0, 0});
    // Truth 0. Within one face of 90 degrees the horizon ends at the face's border: from a face's
    // centre H is the sine of 90 - 45 / 2 degrees and less, so that W = 1 - H^2 is about 0.6. The
    // bound holds the estimator to that: a wrong H^2 or a lost direction leaves it.
    const float centre = at(cube, {0, 0, -1});
    const float borderAngle = 0.5F * std::atan(1.0F);
    EXPECT_NEAR(centre, 1 - std::pow(std::sin(borderAngle), 2.0F), 0.05F);
}

TEST_P(AnalyticGLTest, FalloffWeighsByDistance) {
    Model model;
    addQuad(model, {-20, 0, -20}, {-20, 0, 20}, {20, 0, 20}, {20, 0, -20});
    addBox(model, {1, 0, -20}, {2, 3, 20});
    const auto occlusion = [&](Falloff falloff, float radius) {
        Options options = exact(radius);
        options.falloff = falloff;
        options.horizonSplit.stepSize = 0.05F;
        return 1 - at(capture(model, options, {-0.5F, 6, 0}), {0, 0, 0});
    };
    const float none = occlusion(Falloff::Off, 1.5F);
    const float step = occlusion(Falloff::Step, 1.5F);
    const float beyond = occlusion(Falloff::Step, 0.9F);
    const float exp = occlusion(Falloff::Exp, 1.5F);
    EXPECT_GT(none, 0.2F);
    EXPECT_EQ(beyond, 0.0F) << "the wall is farther than the radius";
    EXPECT_LT(step, none);
    EXPECT_GT(step, 0.0F);
    // All of the wall is at least one unit away: no weight above e^(-1/1.5), none below e^(-4/1.5).
    EXPECT_LT(exp, none * std::exp(-1 / 1.5F) + 0.01F);
    EXPECT_GT(exp, none * std::exp(-4 / 1.5F));
}

AOLIB_FOR_ALL_CONTEXTS(AnalyticGLTest);

} // namespace
} // namespace aolib
