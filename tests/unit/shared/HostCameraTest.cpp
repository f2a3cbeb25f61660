#include "backbone/HostCamera.h"

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

} // namespace
} // namespace aolib
