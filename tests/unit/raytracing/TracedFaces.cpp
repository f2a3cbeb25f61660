#include "TracedFaces.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "TestScenes.h"

namespace aolib::test {

namespace {

/// The normal that W is about at a hit, written out by hand.
glm::dvec3 shadingNormalAt(const TriangleMesh& mesh, const Hit& hit, const glm::dvec3& geometric) {
    if (mesh.normals.empty()) {
        return geometric;
    }
    glm::dvec3 sum(0.0);
    const std::array weights{1.0 - hit.u - hit.v, hit.u, hit.v};
    for (std::size_t corner = 0; corner < 3; ++corner) {
        const std::uint32_t vertex = mesh.indices[3 * std::size_t{hit.triangle} + corner];
        sum += weights[corner] * glm::dvec3(mesh.normals[vertex]);
    }
    if (glm::length(sum) == 0.0) {
        return geometric;
    }
    return (glm::dot(sum, geometric) < 0.0 ? -1.0 : 1.0) * glm::normalize(sum);
}

} // namespace

TexelRequest faceRequest(const glm::dvec3& centre, int face, int rays, Falloff falloff,
                         double radius, int size) {
    TexelRequest request;
    request.centre = glm::vec3(centre);
    request.faceSize = size;
    request.face = face;
    request.width = size;
    request.height = size;
    request.rays = rays;
    request.radius = static_cast<float>(radius);
    request.falloff = falloff;
    return request;
}

TracedTexels traced(const RayScene& scene, const TexelRequest& request) {
    EXPECT_TRUE(checkRequest(request)) << checkRequest(request).message();
    std::optional<TracedTexels> result = traceRequest(scene, request, [] { return true; });
    EXPECT_TRUE(result);
    return *result;
}

glm::dvec3 directionOf(int face, int size, int x, int y) {
    const double u = (2.0 * x + 1.0) / size - 1.0;
    const double v = (2.0 * y + 1.0) / size - 1.0;
    switch (face) {
    case 0:
        return glm::normalize(glm::dvec3(1.0, v, u));
    case 1:
        return glm::normalize(glm::dvec3(-1.0, v, -u));
    case 2:
        return glm::normalize(glm::dvec3(u, 1.0, v));
    case 3:
        return glm::normalize(glm::dvec3(u, -1.0, -v));
    case 4:
        return glm::normalize(glm::dvec3(-u, v, 1.0));
    default:
        return glm::normalize(glm::dvec3(u, v, -1.0));
    }
}

void forEachSeen(const TracedTexels& texels,
                 const std::function<void(std::size_t, const glm::dvec3&)>& call) {
    const TexelRequest& request = texels.request;
    std::size_t i = 0;
    for (int y = request.y; y < request.y + request.height; ++y) {
        for (int x = request.x; x < request.x + request.width; ++x, ++i) {
            if (texels.distance[i] >= 0.0F) {
                call(i, directionOf(request.face, request.faceSize, x, y));
            }
        }
    }
}

std::size_t seenCount(const TracedTexels& texels) {
    return static_cast<std::size_t>(
        std::ranges::count_if(texels.distance, [](float distance) { return distance >= 0.0F; }));
}

double errorAgainstTruth(const RayScene& scene, const TracedTexels& texels) {
    const TexelRequest& request = texels.request;
    const Result<VisibilityTracer> truth =
        VisibilityTracer::create(scene, test::tracing(16384, request.falloff, request.radius));
    double squares = 0.0;
    forEachSeen(texels, [&](std::size_t i, const glm::dvec3& direction) {
        const auto hit = scene.intersect(glm::dvec3(request.centre), direction);
        ASSERT_TRUE(hit);
        EXPECT_NEAR(texels.distance[i], hit->distance, 3e-4 * hit->distance);
        const glm::dvec3 normal =
            glm::dot(hit->normal, direction) > 0.0 ? -hit->normal : hit->normal;
        EXPECT_NEAR(glm::dot(glm::dvec3(texels.normal[i]), normal), 1.0, 1e-6);
        const glm::dvec3 lifted = hit->position + hit->clearance * normal;
        const glm::dvec3 shading = shadingNormalAt(scene.mesh(), *hit, normal);
        const double w = truth->estimate({lifted, shading, 0.0}, i).visibility;
        squares += (w - texels.visibility[i]) * (w - texels.visibility[i]);
    });
    return std::sqrt(squares / double(seenCount(texels)));
}

} // namespace aolib::test
