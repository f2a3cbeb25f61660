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
    const auto truth = [](float d) { return 1 - (1 - d / std::sqrt(d * d + 4)) / 2; };
    // High above, so that floor and wall lie in one face: `step` stops at its border.
    Options options = exact(12.0F);
    const CubeMapImage within = capture(model, options, {1.5F, 6.0F, 0.1F});
    options.falloff = Falloff::Off;
    options.horizonSplit = {.directions = 16, .steps = 64};
    const CubeMapImage cube = capture(model, options, {1.5F, 6.0F, 0.1F});
    for (const float d : {0.5F, 1.0F, 2.0F}) {
        // `step` books a sample under the azimuth of its step, though the wall's upper parts, seen
        // from above, stand in another: measured 0.049, 0.021 and 0.005.
        EXPECT_NEAR(at(within, {d, 0, 0.1F}), truth(d), 0.03F / d) << "at distance " << d;
        // The horizon lies lower than the wall, by up to a step: measured 0.025 and less.
        EXPECT_NEAR(at(cube, {d, 0, 0.1F}), truth(d), 0.03F) << "at distance " << d;
    }
}

/// The inside of a sphere of radius 1.
Model hollowSphere() {
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
    return model;
}

TEST_P(AnalyticGLTest, AClosedRoomIsClosedWithoutFalloff) {
    Model box;
    addBox(box, {-2, -1, -3}, {2, 1, 3});
    for (const Model& model : {hollowSphere(), box}) {
        Options options = atOnce(); // steps and directions as they are by default
        options.falloff = Falloff::Off;
        options.cubeMaps.faceSize = 64;
        options.cubeMaps.place = false;
        const CubeMapImage cube = capture(model, options, {0.2F, 0.1F, -0.1F});
        double sum = 0.0;
        for (const float w : cube.visibility) {
            sum += static_cast<double>(w);
            ASSERT_LT(w, 0.02F);
        }
        EXPECT_LT(sum / static_cast<double>(cube.visibility.size()), 0.005);
    }
}

TEST_P(AnalyticGLTest, ExpWeighsAllOfAClosedSphere) {
    // A chord at an angle theta from the normal is 2 cos(theta) long. With a = 2 / radius the
    // occlusion is the integral of 2 u e^(-a u) for u from 0 to 1.
    for (const float radius : {2.0F, 0.5F, 0.2F}) {
        Options options = exact(radius);
        options.horizonSplit = {.directions = 8, .steps = 64};
        options.cubeMaps.faceSize = 64;
        options.falloff = Falloff::Exp;
        const float a = 2.0F / radius;
        const float truth = 1.0F - 2.0F * (1.0F - (1.0F + a) * std::exp(-a)) / (a * a);
        const CubeMapImage cube = capture(hollowSphere(), options, {0.1F, 0.0F, 0.0F});
        for (const glm::vec3& point :
             {glm::vec3(0, 0, -1), glm::vec3(0, 1, 0), glm::normalize(glm::vec3(1, 0.6F, 0.8F))}) {
            EXPECT_NEAR(at(cube, point), truth, 0.01F) << "radius " << radius;
        }
    }
}

TEST_P(AnalyticGLTest, FalloffWeighsByDistance) {
    Model model;
    addQuad(model, {-20, 0, -20}, {-20, 0, 20}, {20, 0, 20}, {20, 0, -20});
    addBox(model, {1, 0, -20}, {2, 3, 20});
    const auto occlusion = [&](Falloff falloff, float radius) {
        Options options = exact(radius);
        options.falloff = falloff;
        options.horizonSplit = {.directions = 16, .steps = 64, .stepSize = 0.05F};
        options.cubeMaps.faceSize = 64;
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
