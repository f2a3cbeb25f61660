#include <cmath>
#include <limits>
#include <numbers>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "BakeScenes.h"
#include "reference/ClosedForms.h"

namespace aolib::bake::test {

namespace {

/// The x of a column's centre on the unit floor.
double placeOf(int column, int size) {
    return (column + 0.5) / size;
}

double rmseBesideWall(const RayOptions& options, double height) {
    auto baker = createRayBaker(floorBesideWall(height), options);
    EXPECT_TRUE(baker.ok()) << baker.status().message();
    const BakedMap map = onlyMap(**baker, 32);
    double sum = 0.0;
    for (int y = 0; y < 32; ++y) {
        for (int x = 0; x < 32; ++x) {
            const double truth = 1.0 - wallOcclusion(height, placeOf(x, 32));
            const double error = double(map.visibility[std::size_t(y * 32 + x)]) - truth;
            sum += error * error;
        }
    }
    return std::sqrt(sum / (32.0 * 32.0));
}

TEST(RayBakerTest, FloorBesideAWallIsAsDarkAsTheFormFactorSays) {
    RayOptions options;
    options.rays = 1024;
    // Stratified sampling of a straight edge: well below the 0.5 / sqrt(1024) = 0.016 of chance.
    EXPECT_LT(rmseBesideWall(options, 0.5), 0.004);
    EXPECT_LT(rmseBesideWall(options, 5.0), 0.004);
}

TEST(RayBakerTest, AnyNumberOfRaysWillDo) {
    for (const int rays : {1, 3, 100, 300, 1000}) {
        RayOptions options;
        options.rays = rays;
        EXPECT_LT(rmseBesideWall(options, 0.5), 0.6 / std::sqrt(double(rays))) << rays;
    }
}

TEST(RayBakerTest, RejectionAimsAtTheSameAndIsNoisier) {
    RayOptions options;
    options.rays = 1024;
    const double stratified = rmseBesideWall(options, 0.5);
    options.sampling = Sampling::Rejection;
    const double rejection = rmseBesideWall(options, 0.5);
    EXPECT_LT(rejection, 0.03);
    EXPECT_GT(rejection, 3.0 * stratified);
}

TEST(RayBakerTest, SolidAngleIsThePlainShareOfOpenDirections) {
    // Beside the foot of an endless wall half of all directions are open, whatever the measure; at
    // the distance of its height the wedge below 45 degrees is closed: a quarter of the half.
    for (const Sampling sampling : {Sampling::Stratified, Sampling::Rejection}) {
        RayOptions options;
        options.rays = 16384;
        options.sampling = sampling;
        options.measure = Measure::SolidAngle;
        auto baker = createRayBaker(floorBesideWall(0.5), options);
        ASSERT_TRUE(baker.ok());
        const BakedMap map = onlyMap(**baker, 8);
        const double place = placeOf(4, 8);
        const double wedge = std::atan(0.5 / place) / std::numbers::pi;
        EXPECT_NEAR(double(map.visibility[4]), 1.0 - wedge, 0.015);
    }
}

TEST(RayBakerTest, BentNormalAtAWallsFootLeansAway) {
    RayOptions options;
    options.rays = 4096;
    auto baker = createRayBaker(floorBesideWall(1e4), options);
    ASSERT_TRUE(baker.ok());
    const BakedMap map = onlyMap(**baker, 4);
    // Of the open quarter sphere: integrals of x z and z^2 are 2/3 and pi/3.
    const glm::vec3 expected = glm::normalize(glm::vec3(2.0F / 3.0F, 1.0471976F, 0.0F));
    for (const glm::vec3& normal : map.bentNormal) {
        EXPECT_GT(glm::dot(normal, expected), 0.9999F);
    }
}

TEST(RayBakerTest, LonePlaneIsOpenAndClosedRoomIsClosed) {
    for (const float w : bakeRays(sceneOf(unitFloor(3)), 64, 16).visibility) {
        EXPECT_EQ(w, 1.0F);
    }
    UvMesh room;
    addUvBox(room, glm::vec3(-1.0F), glm::vec3(1.0F), 2, {}, true);
    const BakedMap closed = bakeRays(sceneOf(room), 64, 64);
    for (std::size_t i = 0; i < closed.visibility.size(); ++i) {
        EXPECT_LE(closed.visibility[i], 0.0F);
    }
}

TEST(RayBakerTest, TexelsInACreaseAreNotBlack) {
    // In the corners of an open box, about a third of the sky is open from everywhere on the edge.
    UvMesh box;
    addUvBox(box, glm::vec3(-1.0F, -0.1F, -1.0F), glm::vec3(1.0F, 0.1F, 1.0F), 1, {}, true, false);
    for (const int size : {48, 96, 100}) { // edges along texels' borders, centres, neither
        const BakedMap map = bakeRays(sceneOf(box), 256, size);
        for (std::size_t i = 0; i < map.visibility.size(); ++i) {
            if (map.kind[i] != TexelKind::Empty) {
                EXPECT_GT(map.visibility[i], 0.1F) << i << " of " << size;
            }
        }
    }
    RayOptions options;
    auto baker = createRayBaker(sceneOf(box), options);
    ASSERT_TRUE(baker.ok());
    const auto vertices = (*baker)->bakeVertices({}, {});
    ASSERT_TRUE(vertices.ok());
    for (const float w : vertices->front().visibility) {
        EXPECT_GT(w, 0.1F);
    }
}

TEST(RayBakerTest, RadiusAndFalloffFollowTheClosedForms) {
    UvMesh sphere;
    addUvSphere(sphere, {3.0F, 0.0F, 0.0F}, 1.0F, 128, 64);
    for (std::size_t i = 0; i < sphere.indices.size(); i += 3) {
        std::swap(sphere.indices[i + 1], sphere.indices[i + 2]);
    }
    for (glm::vec3& normal : sphere.normals) {
        normal = -normal;
    }
    RayOptions options;
    options.rays = 1024;
    options.radius = 0.9F;
    const auto meanOf = [&] {
        auto baker = createRayBaker(sceneOf(sphere), options);
        EXPECT_TRUE(baker.ok());
        const BakedMap map = onlyMap(**baker, 32);
        double sum = 0.0;
        for (const float w : map.visibility) {
            sum += double(w);
        }
        return sum / double(map.visibility.size());
    };
    EXPECT_NEAR(1.0 - meanOf(), insideSphereOcclusionStep(1.0, 0.9), 0.01);
    options.falloff = Falloff::Exp;
    EXPECT_NEAR(1.0 - meanOf(), insideSphereOcclusionExp(1.0, 0.9), 0.01);
    options.falloff = Falloff::Off;
    EXPECT_NEAR(1.0 - meanOf(), 1.0, 1e-6);
}

TEST(RayBakerTest, GroundAndDomeDarkenWhatLooksDown) {
    UvMesh wall;
    addUvQuad(wall, {0.0F, 0.5F, 0.0F}, {1.0F, 0.0F, 0.0F}, {0.0F, 1.0F, 0.0F}, 1);
    BakeScene scene = sceneOf(wall);
    scene.ground = 0.0F;
    for (const float w : bakeRays(scene, 1024, 4).visibility) {
        EXPECT_NEAR(w, 0.5F, 0.01F);
    }
    scene.ground.reset();
    RayOptions options;
    options.rays = 1024;
    options.sky = Sky::Dome;
    auto baker = createRayBaker(scene, options);
    ASSERT_TRUE(baker.ok());
    for (const float w : onlyMap(**baker, 4).visibility) {
        EXPECT_NEAR(w, 0.5F, 0.01F);
    }
    // Out of the ground's reach everything is open.
    scene.ground = -2.0F;
    options.sky = Sky::Sphere;
    options.radius = 1.0F;
    auto far = createRayBaker(scene, options);
    ASSERT_TRUE(far.ok());
    for (const float w : onlyMap(**far, 4).visibility) {
        EXPECT_EQ(w, 1.0F);
    }
}

TEST(RayBakerTest, DirectionsBelowATrianglesPlaneAreClosed) {
    UvMesh floor = unitFloor(1);
    for (glm::vec3& normal : floor.normals) {
        normal = glm::normalize(glm::vec3(1.0F, 1.0F, 0.0F));
    }
    // Half a hemisphere and the wedge of 45 degrees: (1 + cos 45) / 2.
    for (const float w : bakeRays(sceneOf(floor), 4096, 2).visibility) {
        EXPECT_NEAR(w, 0.8536F, 0.005F);
    }
}

TEST(RayBakerTest, MissingNormalsAndDegenerateTrianglesAreTakenAsTheyAre) {
    BakeScene scene = floorBesideWall(0.5);
    scene.surfaces[0].normals.clear();
    const std::uint32_t first = scene.surfaces[0].indices[0];
    scene.surfaces[0].indices.insert(scene.surfaces[0].indices.end(), {first, first, first});
    const BakedMap map = bakeRays(scene, 1024, 8);
    EXPECT_NEAR(double(map.visibility[7]), 1.0 - wallOcclusion(0.5, placeOf(7, 8)), 0.01);
    scene.surfaces[0].normals.assign(scene.surfaces[0].positions.size(),
                                     glm::vec3(std::numeric_limits<float>::quiet_NaN()));
    EXPECT_EQ(bakeRays(scene, 1024, 8).visibility, map.visibility);
}

TEST(RayBakerTest, ThreadsDoNotChangeTheResultAndSeedsDo) {
    RayOptions options;
    options.rays = 32;
    options.threads = 1;
    auto one = createRayBaker(floorBesideWall(0.5), options);
    options.threads = 3;
    auto three = createRayBaker(floorBesideWall(0.5), options);
    options.seed = 1;
    auto other = createRayBaker(floorBesideWall(0.5), options);
    ASSERT_TRUE(one.ok() && three.ok() && other.ok());
    const BakedMap first = onlyMap(**one, 64);
    EXPECT_EQ(first.visibility, onlyMap(**three, 64).visibility);
    EXPECT_NE(first.visibility, onlyMap(**other, 64).visibility);
}

TEST(RayBakerTest, ProgressRisesAndCancels) {
    RayOptions options;
    options.rays = 64;
    auto baker = createRayBaker(floorBesideWall(0.5), options);
    ASSERT_TRUE(baker.ok());
    MapOptions maps;
    maps.width = 128;
    maps.height = 128;
    double last = -1.0;
    ASSERT_TRUE((*baker)
                    ->bakeMaps(maps,
                               [&](double fraction) {
                                   EXPECT_GE(fraction, last);
                                   last = fraction;
                                   return true;
                               })
                    .ok());
    EXPECT_EQ(last, 1.0);
    const auto cancelled = (*baker)->bakeMaps(maps, [](double) { return false; });
    EXPECT_EQ(cancelled.status().code(), StatusCode::Cancelled);
    const auto vertices = (*baker)->bakeVertices({}, [](double) { return false; });
    EXPECT_EQ(vertices.status().code(), StatusCode::Cancelled);
}

TEST(RayBakerTest, EveryMisuseHasItsCode) {
    const auto codeOf = [](const BakeScene& scene, const RayOptions& options = {}) {
        return createRayBaker(scene, options).status().code();
    };
    const BakeScene good = floorBesideWall(0.5);
    EXPECT_EQ(codeOf(good), StatusCode::Ok);
    EXPECT_EQ(codeOf({}), StatusCode::EmptyMesh);
    BakeScene bad = good;
    bad.surfaces[1].indices.push_back(0);
    EXPECT_EQ(codeOf(bad), StatusCode::IncompletePrimitive);
    bad = good;
    bad.surfaces[1].indices[0] = 99;
    EXPECT_EQ(codeOf(bad), StatusCode::InvalidIndex);
    bad = good;
    bad.surfaces[0].positions[1].y = std::numeric_limits<float>::infinity();
    EXPECT_EQ(codeOf(bad), StatusCode::InvalidPosition);
    bad = good;
    bad.surfaces[0].normals.pop_back();
    EXPECT_EQ(codeOf(bad), StatusCode::InvalidNormal);
    bad = good;
    bad.surfaces[0].uvs.pop_back();
    EXPECT_EQ(codeOf(bad), StatusCode::InvalidOption);
    bad = good;
    bad.surfaces[0].map = -2;
    EXPECT_EQ(codeOf(bad), StatusCode::InvalidOption);
    bad = good;
    bad.up = glm::vec3(0.0F);
    EXPECT_EQ(codeOf(bad), StatusCode::InvalidOption);
    RayOptions options;
    options.rays = 0;
    EXPECT_EQ(codeOf(good, options), StatusCode::InvalidOption);
    options.rays = 4;
    options.radius = -1.0F;
    EXPECT_EQ(codeOf(good, options), StatusCode::InvalidOption);
    auto baker = createRayBaker(good, {});
    ASSERT_TRUE(baker.ok());
    MapOptions maps;
    maps.width = 0;
    EXPECT_EQ((*baker)->bakeMaps(maps, {}).status().code(), StatusCode::InvalidOption);
    VertexOptions vertices;
    vertices.density = 0.0F;
    EXPECT_EQ((*baker)->bakeVertices(vertices, {}).status().code(), StatusCode::InvalidOption);
    bad = good;
    bad.surfaces[0].uvs.clear();
    auto blind = createRayBaker(bad, {});
    ASSERT_TRUE(blind.ok());
    EXPECT_EQ((*blind)->bakeMaps({}, {}).status().code(), StatusCode::InvalidPosition);
}

} // namespace

} // namespace aolib::bake::test
