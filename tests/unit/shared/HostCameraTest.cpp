#include "backbone/HostCamera.h"

#include <cmath>
#include <limits>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace aolib {
namespace {

const glm::mat4 kView = glm::lookAt(glm::vec3(3, 4, 5), glm::vec3(0), glm::vec3(0, 1, 0));
const glm::mat4 kPerspective = glm::perspective(0.8F, 1.5F, 0.1F, 100.0F);

StatusCode codeOf(const glm::mat4& view, const glm::mat4& projection) {
    return HostCamera::create(view, projection).status().code();
}

TEST(HostCameraTest, FindsTheEye) {
    const auto camera = HostCamera::create(kView, kPerspective);
    ASSERT_TRUE(camera.ok());
    EXPECT_NEAR(glm::distance(camera->eye(), glm::dvec3(3, 4, 5)), 0.0, 1e-5);
}

TEST(HostCameraTest, TellsReversedDepth) {
    glm::mat4 reversed = kPerspective;
    reversed[2][2] = -kPerspective[2][2] - 1.0F; // near to 1, far to 0
    reversed[3][2] = -kPerspective[3][2];
    EXPECT_FALSE(HostCamera::create(kView, kPerspective)->reversedDepth());
    EXPECT_TRUE(HostCamera::create(kView, reversed)->reversedDepth());
    EXPECT_FALSE(HostCamera::create(kView, glm::ortho(-1.0F, 1.0F, -1.0F, 1.0F, 0.1F, 9.0F))
                     ->reversedDepth());
    EXPECT_TRUE(HostCamera::create(kView, glm::ortho(-1.0F, 1.0F, -1.0F, 1.0F, 9.0F, 0.1F))
                    ->reversedDepth());
}

TEST(HostCameraTest, AcceptsOffCentreAndInfinite) {
    EXPECT_EQ(codeOf(kView, glm::frustum(-0.1F, 0.3F, -0.2F, 0.1F, 0.1F, 50.0F)), StatusCode::Ok);
    EXPECT_EQ(codeOf(kView, glm::infinitePerspective(0.8F, 1.5F, 0.1F)), StatusCode::Ok);
}

TEST(HostCameraTest, RefusesWhatIsNoCamera) {
    glm::mat4 nan = kPerspective;
    nan[1][1] = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(codeOf(kView, nan), StatusCode::InvalidCamera);
    EXPECT_EQ(codeOf(nan, kPerspective), StatusCode::InvalidCamera);
    EXPECT_EQ(codeOf(glm::scale(kView, glm::vec3(2.0F)), kPerspective), StatusCode::InvalidCamera);
    EXPECT_EQ(codeOf(glm::mat4(0.0F), kPerspective), StatusCode::InvalidCamera);
    EXPECT_EQ(codeOf(kView, glm::mat4(0.0F)), StatusCode::InvalidCamera);
    EXPECT_EQ(codeOf(kView, kPerspective * kView), StatusCode::InvalidCamera);
}

/// A point's window position and depth, by OpenGL's own rules, lead back to the point.
TEST(HostCameraTest, FindsTheSurfaceBehindAPixel) {
    glm::mat4 reversed = glm::infinitePerspective(0.8F, 1.5F, 0.1F);
    reversed[2][2] = -reversed[2][2] - 1.0F;
    reversed[3][2] = -reversed[3][2];
    const glm::ivec2 size(300, 200);
    for (const glm::mat4& projection :
         {kPerspective, glm::frustum(-0.1F, 0.3F, -0.2F, 0.1F, 0.1F, 50.0F), reversed,
          glm::ortho(-3.0F, 2.0F, -1.0F, 2.0F, 0.1F, 9.0F)}) {
        const auto camera = HostCamera::create(kView, projection);
        ASSERT_TRUE(camera.ok());
        for (const ClipConvention& clip :
             {ClipConvention{}, ClipConvention{.upperLeft = true, .depthRange = {0.25, 0.75}}}) {
            // Through the middle of pixel (210, 60), at several depths.
            for (const double ndcZ : {0.1, 0.5, 0.9}) {
                const double windowZ = 0.5 * (ndcZ + 1.0);
                const double depth =
                    clip.depthRange[0] + windowZ * (clip.depthRange[1] - clip.depthRange[0]);
                const HostCamera::Surface surface = camera->surfaceAt({210, 60}, depth, size, clip);
                const glm::dvec4 p = glm::dmat4(projection) * glm::dmat4(kView) *
                                     glm::dvec4(camera->eye() + surface.position, 1.0);
                EXPECT_NEAR(p.x / p.w, 210.5 / 150.0 - 1.0, 1e-5);
                EXPECT_NEAR(p.y / p.w, (60.5 / 100.0 - 1.0) * (clip.upperLeft ? -1.0 : 1.0), 1e-5);
                EXPECT_NEAR(p.z / p.w, ndcZ, 1e-5);
                // One pixel further up, seen square on.
                const glm::dvec3 above = camera->surfaceAt({210, 61}, depth, size, clip).position;
                EXPECT_NEAR(glm::distance(above, surface.position), surface.footprint,
                            1e-6 * surface.footprint);
                // A step of the depth buffer further away.
                const glm::dvec3 behind =
                    camera->surfaceAt({210, 60}, depth + clip.depthQuantum, size, clip).position;
                const double along = glm::dot(glm::dmat3(kView) * (behind - surface.position),
                                              glm::dvec3(0.0, 0.0, 1.0));
                EXPECT_NEAR(std::abs(along), surface.resolution, 1e-3 * surface.resolution);
                EXPECT_GT(glm::dot(surface.viewer, glm::dvec3(3, 4, 5)), 0.0);
            }
        }
    }
}

} // namespace
} // namespace aolib
