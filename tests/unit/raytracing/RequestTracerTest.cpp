#include "raytracing/RequestTracer.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <span>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "TestScenes.h"
#include "TracedFaces.h"
#include "reference/ClosedForms.h"

namespace aolib {
namespace {

using test::directionOf;
using test::errorAgainstTruth;
using test::faceRequest;
using test::forEachSeen;
using test::sceneOf;
using test::seenCount;
using test::traced;

/// A floor, a wall, a box on the floor in scale 1/2 and a disc in the air: faces that look in every
/// direction, edges, and open sky.
TriangleMesh clutter(double scale = 1.0, const glm::dvec3& offset = glm::dvec3(0.0)) {
    TriangleMesh mesh = test::floorAndWall(3.0);
    const auto add = [&mesh](const TriangleMesh& other, double size, const glm::vec3& by) {
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        for (const glm::vec3& p : other.positions) {
            mesh.positions.push_back(float(size) * p + by);
        }
        for (const std::uint32_t i : other.indices) {
            mesh.indices.push_back(first + i);
        }
    };
    add(test::box(), 0.5, {3.5F, 0.5F, 0.5F});
    add(test::disc(1.0, 0.0), 1.0, {1.5F, 2.5F, 0.0F});
    for (glm::vec3& p : mesh.positions) {
        p = glm::vec3(offset + scale * glm::dvec3(p));
    }
    return mesh;
}

TEST(RequestTracer, ConvergesToTheTruthInEveryFalloff) {
    const RayScene scene = sceneOf(clutter());
    const glm::dvec3 eye(2.037, 1.219, -0.413);
    for (const Falloff falloff : {Falloff::Step, Falloff::Exp, Falloff::Off}) {
        for (int face = 0; face < 6; ++face) {
            SCOPED_TRACE(face);
            const TracedTexels texels = traced(scene, faceRequest(eye, face, 4096, falloff, 1.5));
            EXPECT_GT(seenCount(texels), 7U);
            // The truth's own noise is about 0.001.
            EXPECT_LT(errorAgainstTruth(scene, texels), 0.003) << static_cast<int>(falloff);
        }
    }
}

TEST(RequestTracer, ScaleAndDistanceFromTheOriginDoNotMatter) {
    struct Place {
        double scale;
        glm::dvec3 offset;
    };
    for (const Place& place :
         {Place{1e-4, {}}, Place{1e5, {}}, Place{1.0, {8192.0, -8192.0, 0.0}}}) {
        const RayScene scene = sceneOf(clutter(place.scale, place.offset));
        const glm::dvec3 eye = place.offset + place.scale * glm::dvec3(2.037, 1.219, -0.413);
        for (int face = 0; face < 6; ++face) {
            const TracedTexels texels =
                traced(scene, faceRequest(eye, face, 4096, Falloff::Step, 1.5 * place.scale));
            EXPECT_LT(errorAgainstTruth(scene, texels), 0.003) << place.scale << " face " << face;
        }
    }
}

TEST(RequestTracer, FloorBesideAWall) {
    const RayScene scene = sceneOf(test::floorAndWall(2.0));
    const TracedTexels texels = traced(scene, faceRequest({3.0, 1.0, 0.0}, 3, 4096));
    ASSERT_EQ(seenCount(texels), 64U);
    forEachSeen(texels, [&](std::size_t i, const glm::dvec3& direction) {
        const double distance = 3.0 + texels.distance[i] * direction.x;
        EXPECT_NEAR(texels.distance[i] * direction.y, -1.0, 1e-6);
        EXPECT_NEAR(1.0 - texels.visibility[i], wallOcclusion(2.0, distance), 0.004);
        EXPECT_EQ(texels.normal[i], glm::vec3(0.0F, 1.0F, 0.0F));
    });
}

TEST(RequestTracer, InsideOfASphere) {
    const RayScene scene = sceneOf(test::sphere(2.0));
    for (int face = 0; face < 6; ++face) {
        const glm::dvec3 eye(0.3, -0.4, 0.2);
        const TracedTexels step = traced(scene, faceRequest(eye, face, 1024, Falloff::Step, 2.0));
        const TracedTexels exp = traced(scene, faceRequest(eye, face, 1024, Falloff::Exp, 2.0));
        for (std::size_t i = 0; i < 64; ++i) {
            EXPECT_NEAR(1.0 - step.visibility[i], insideSphereOcclusionStep(2.0, 2.0), 0.01);
            EXPECT_NEAR(1.0 - exp.visibility[i], insideSphereOcclusionExp(2.0, 2.0), 0.005);
        }
    }
}

/// Not a ray leaks through the edges of a closed room, and none meets the plane that it leaves.
TEST(RequestTracer, ClosedRoomAndLonePlaneAreExact) {
    const RayScene room = sceneOf(test::box());
    TriangleMesh plane;
    test::addQuad(plane, {-50.0, 0.3, -30.0}, {20.0, 11.0, 90.0}, {80.0, -7.0, 10.0});
    const RayScene open = sceneOf(plane);
    for (int face = 0; face < 6; ++face) {
        const TracedTexels inside =
            traced(room, faceRequest({0.3, -0.2, 0.1}, face, 320, Falloff::Off, 1.0, 32));
        const TracedTexels above =
            traced(open, faceRequest({5.0, 9.0, 7.0}, face, 320, Falloff::Off, 1.0, 32));
        EXPECT_EQ(seenCount(inside), 1024U);
        EXPECT_EQ(*std::ranges::max_element(inside.visibility), 0.0F) << face;
        EXPECT_EQ(*std::ranges::min_element(above.visibility), 1.0F) << face;
    }
}

TEST(RequestTracer, RowZeroIsAtTheBottom) {
    const RayScene scene = sceneOf(test::floorAndWall(0.001));
    const TracedTexels texels = traced(scene, faceRequest({3.0, 1.0, 0.0}, 0, 4));
    for (std::size_t i = 0; i < 64; ++i) {
        EXPECT_EQ(texels.distance[i] >= 0.0F, i < 32) << i;
    }
}

TEST(RequestTracer, ATexelThatSeesNothingIsOpen) {
    const TriangleMesh none;
    TriangleMesh degenerate;
    degenerate.positions = {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}};
    degenerate.indices = {0, 1, 2, 0, 0, 1};
    for (const TriangleMesh& mesh : {none, degenerate}) {
        const RayScene scene = sceneOf(mesh);
        const TracedTexels texels = traced(scene, faceRequest({0.5, 0.5, 0.5}, 4, 16));
        for (std::size_t i = 0; i < 64; ++i) {
            EXPECT_EQ(texels.visibility[i], 1.0F);
            EXPECT_EQ(texels.distance[i], -1.0F);
            EXPECT_EQ(texels.normal[i], glm::vec3(0.0F));
        }
    }
}

/// From a point on the floor, the floor is not seen and everything else is.
TEST(RequestTracer, CentreOnASurface) {
    const RayScene scene = sceneOf(test::floorAndWall(4.0));
    const glm::dvec3 eye(1.0, 0.0, 0.0);
    EXPECT_EQ(seenCount(traced(scene, faceRequest(eye, 3, 16))), 0U);
    const TracedTexels wall = traced(scene, faceRequest(eye, 1, 4096));
    EXPECT_EQ(seenCount(wall), 32U);
    forEachSeen(wall, [&](std::size_t i, const glm::dvec3& direction) {
        EXPECT_NEAR(wall.distance[i] * direction.x, -1.0, 1e-6);
        EXPECT_GT(wall.visibility[i], 0.4F);
        EXPECT_LT(wall.visibility[i], 1.0F);
    });
}

/// However the rays are cut into requests, they are the same rays.
TEST(RequestTracer, ConsecutiveRequestsContinueOneSequence) {
    const RayScene scene = sceneOf(clutter());
    TexelRequest request = faceRequest({2.0, 1.2, -0.4}, 5, 200, Falloff::Step, 1.5);
    const TracedTexels whole = traced(scene, request);
    for (const std::vector<int>& cuts :
         {std::vector{64, 136}, {4, 12, 16, 168}, {1, 2, 5, 83, 109}}) {
        std::vector<double> sums(64, 0.0);
        int first = 0;
        for (const int rays : cuts) {
            request.firstRay = first;
            request.rays = rays;
            const TracedTexels part = traced(scene, request);
            for (std::size_t i = 0; i < 64; ++i) {
                sums[i] += double(rays) * part.visibility[i];
            }
            first += rays;
        }
        for (std::size_t i = 0; i < 64; ++i) {
            EXPECT_NEAR(sums[i] / 200.0, whole.visibility[i], 1e-5);
        }
    }
}

/// Nor does it matter which texels are asked for together: only a ray through an edge may differ,
/// as packets round otherwise than others.
TEST(RequestTracer, ATexelsResultDoesNotDependOnItsNeighbours) {
    const RayScene scene = sceneOf(clutter());
    TexelRequest request = faceRequest({2.0, 1.2, -0.4}, 5, 64, Falloff::Step, 1.5, 16);
    const TracedTexels whole = traced(scene, request);
    int differing = 0;
    for (const int edge : {1, 3, 5}) {
        for (int y = 0; y + edge <= 16; y += edge) {
            for (int x = 0; x + edge <= 16; x += edge) {
                request.x = x;
                request.y = y;
                request.width = edge;
                request.height = edge;
                const TracedTexels part = traced(scene, request);
                for (int i = 0; i < edge * edge; ++i) {
                    const auto place = static_cast<std::size_t>((y + i / edge) * 16 + x + i % edge);
                    const auto mine = static_cast<std::size_t>(i);
                    EXPECT_NEAR(part.visibility[mine], whole.visibility[place], 1.1F / 64.0F);
                    EXPECT_EQ(part.distance[mine], whole.distance[place]);
                    differing += part.visibility[mine] == whole.visibility[place] ? 0 : 1;
                }
            }
        }
    }
    EXPECT_LE(differing, 4);
}

TEST(RequestTracer, SameRequestSameResult) {
    const RayScene scene = sceneOf(clutter());
    const TexelRequest request = faceRequest({2.0, 1.2, -0.4}, 5, 37, Falloff::Exp, 1.5);
    EXPECT_EQ(traced(scene, request).visibility, traced(scene, request).visibility);
}

/// A line of sight towards what a texel sees finds the same surface, by the same rays.
TEST(RequestTracer, LinesOfSightFindWhatLiesBetweenTheirEnds) {
    const RayScene scene = sceneOf(clutter());
    const TexelRequest request = faceRequest({2.0, 1.2, -0.4}, 5, 256, Falloff::Step, 1.5);
    const TracedTexels texels = traced(scene, request);
    TexelRequest sighted = request;
    TexelRequest tooShort = request;
    for (int i = 0; i < 64; ++i) {
        const glm::vec3 along(directionOf(5, 8, i % 8, i / 8));
        const float distance = texels.distance[static_cast<std::size_t>(i)];
        const float reach = distance < 0.0F ? 100.0F : distance;
        sighted.primaryRays.push_back({0.9F * reach * along, 1.1F * reach * along});
        tooShort.primaryRays.push_back({0.2F * reach * along, 0.99F * reach * along});
    }
    const TracedTexels seen = traced(scene, sighted);
    forEachSeen(texels, [&](std::size_t i, const glm::dvec3&) {
        EXPECT_NEAR(seen.distance[i], 0.1F * texels.distance[i], 1e-4F * texels.distance[i]);
        EXPECT_EQ(seen.normal[i], texels.normal[i]);
        EXPECT_NEAR(seen.visibility[i], texels.visibility[i], 2.1F / 256.0F);
    });
    EXPECT_EQ(seenCount(seen), seenCount(texels));
    EXPECT_EQ(seenCount(traced(scene, tooShort)), 0U);
}

TEST(RequestTracer, StopsWithinFourThousandRays) {
    const RayScene scene = sceneOf(clutter());
    const TexelRequest request = faceRequest({2.0, 1.2, -0.4}, 3, 1024, Falloff::Step, 1.0, 16);
    int asked = 0;
    EXPECT_TRUE(traceRequest(scene, request, [&] { return ++asked > 0; }));
    EXPECT_GE(asked, 16 * 16 * 1024 / 4096);
    for (const int most : {1, 7, 40}) {
        asked = 0;
        EXPECT_FALSE(traceRequest(scene, request, [&] { return ++asked < most; }));
        EXPECT_EQ(asked, most);
    }
    asked = 0;
    EXPECT_FALSE(traceRequest(sceneOf({}), request, [&] { return ++asked < 5; }))
        << "where nothing is seen as well";
}

TEST(RequestTracer, RequestsOutOfRangeAreRefused) {
    const TexelRequest good = faceRequest({0.0, 0.0, 0.0}, 0, 16, Falloff::Step, 1.0);
    EXPECT_TRUE(checkRequest(good));
    const auto refused = [&](const std::function<void(TexelRequest&)>& change) {
        TexelRequest request = good;
        change(request);
        return checkRequest(request).code();
    };
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const int huge = std::numeric_limits<int>::max();
    constexpr StatusCode invalid = StatusCode::InvalidOption;
    EXPECT_EQ(refused([&](auto& r) { r.centre.y = nan; }), StatusCode::InvalidPosition);
    EXPECT_EQ(refused([](auto& r) { r.face = 6; }), invalid);
    EXPECT_EQ(refused([](auto& r) { r.face = -1; }), invalid);
    EXPECT_EQ(refused([](auto& r) { r.faceSize = 0; }), invalid);
    EXPECT_EQ(refused([](auto& r) { r.faceSize = 65537; }), invalid);
    EXPECT_EQ(refused([](auto& r) { r.x = 1; }), invalid);
    EXPECT_EQ(refused([](auto& r) { r.y = -1; }), invalid);
    EXPECT_EQ(refused([](auto& r) { r.width = 0; }), invalid);
    EXPECT_EQ(refused([=](auto& r) { r.x = 1, r.width = huge; }), invalid);
    EXPECT_EQ(refused([](auto& r) { r.height = 9; }), invalid);
    EXPECT_EQ(refused([](auto& r) { r.faceSize = r.width = r.height = 4097; }), invalid);
    EXPECT_EQ(refused([](auto& r) { r.faceSize = r.width = r.height = 4096; }), StatusCode::Ok);
    EXPECT_EQ(refused([](auto& r) { r.rays = 0; }), invalid);
    EXPECT_EQ(refused([](auto& r) { r.firstRay = -16; }), invalid);
    EXPECT_EQ(refused([=](auto& r) { r.firstRay = 1, r.rays = huge; }), invalid);
    EXPECT_EQ(refused([](auto& r) { r.radius = 0.0F; }), invalid);
    const std::vector<LineOfSight> primaryRays(64, LineOfSight{{0, 0, 0}, {0, 0, 1}});
    EXPECT_EQ(refused([&](auto& r) { r.primaryRays = primaryRays, r.x = r.y = 9000; }),
              StatusCode::Ok);
    EXPECT_EQ(refused([&](auto& r) { r.primaryRays = primaryRays, r.height = 7; }), invalid);
    EXPECT_EQ(refused([&](auto& r) { r.primaryRays = primaryRays, r.primaryRays[9].to.z = 0.0F; }),
              StatusCode::InvalidPosition);
    EXPECT_EQ(refused([&](auto& r) { r.primaryRays = primaryRays, r.primaryRays[9].to.z = nan; }),
              StatusCode::InvalidPosition);
    EXPECT_EQ(refused([&](auto& r) { r.radius = nan; }), invalid);
    EXPECT_EQ(refused([](auto& r) { r.radius = 0.0F, r.falloff = Falloff::Off; }), StatusCode::Ok);
}

} // namespace
} // namespace aolib
