#include "backbone/frame/HostCamera.h"

#include <cmath>
#include <limits>
#include <vector>

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

/// Matrices of eye space, or of clip space, that a projection may contain.
glm::mat4 scaled(float x, float y, float z) {
    return glm::scale(glm::mat4(1.0F), {x, y, z});
}
const glm::mat4 kMirrorZ = scaled(1.0F, 1.0F, -1.0F);

std::vector<glm::mat4> rightHanded() {
    glm::mat4 reversed = glm::infinitePerspective(0.8F, 1.5F, 0.1F);
    reversed[2][2] = -reversed[2][2] - 1.0F;
    reversed[3][2] = -reversed[3][2];
    return {kPerspective,
            glm::frustum(-0.1F, 0.3F, -0.2F, 0.1F, 0.1F, 50.0F),
            glm::infinitePerspective(0.8F, 1.5F, 0.1F),
            reversed,
            kMirrorZ * kPerspective,
            glm::ortho(-3.0F, 2.0F, -1.0F, 2.0F, 0.1F, 9.0F),
            glm::ortho(-3.0F, 2.0F, -1.0F, 2.0F, 9.0F, 0.1F)};
}

TEST(HostCameraTest, EquivalentMatricesAreTheSameCamera) {
    for (const glm::mat4& projection : rightHanded()) {
        const HostCamera camera = *HostCamera::create(kView, projection)->under({}, false);
        const auto expectSame = [&](const glm::mat4& view, const glm::mat4& other) {
            const auto created = HostCamera::create(view, other);
            ASSERT_TRUE(created.ok()) << created.status().message();
            EXPECT_EQ(*created->under({}, false), camera);
        };
        expectSame(kMirrorZ * kView, projection * kMirrorZ);
        expectSame(kMirrorZ * kView, 4.0F * projection * kMirrorZ);
        expectSame(kView, 0.5F * projection);
        for (const glm::mat4& mirror : {scaled(-1, 1, 1), scaled(1, -1, 1), scaled(-1, -1, -1)}) {
            expectSame(mirror * kView, projection * mirror);
        }
    }
    // The host's matrices of another handedness: the product says all.
    EXPECT_EQ(*HostCamera::create(kMirrorZ * kView, glm::perspectiveLH_NO(0.8F, 1.5F, 0.1F, 9.0F)),
              *HostCamera::create(kView, glm::perspectiveRH_NO(0.8F, 1.5F, 0.1F, 9.0F)));
    EXPECT_FALSE(HostCamera::create(glm::lookAtLH(glm::vec3(3, 4, 5), glm::vec3(0), {0, 1, 0}),
                                    glm::perspectiveLH_ZO(0.8F, 1.5F, 0.1F, 9.0F))
                     ->reversedDepth());
}

TEST(HostCameraTest, OrthographicLooksToWhereItsDepthIs) {
    const glm::mat4 around = glm::ortho(-3.0F, 2.0F, -1.0F, 2.0F, -9.0F, 9.0F);
    for (const bool reversed : {false, true}) {
        const glm::mat4 right = reversed ? kMirrorZ * around : around;
        const HostCamera camera = *HostCamera::create(kView, right)->under({}, reversed);
        EXPECT_EQ(camera.reversedDepth(), reversed);
        EXPECT_EQ(*HostCamera::create(kMirrorZ * kView, right * kMirrorZ)->under({}, reversed),
                  camera);
        // A reversed glDepthRange exchanges what is greater.
        const ClipConvention range{.depthRange = {1.0, 0.0}};
        EXPECT_EQ(*HostCamera::create(kMirrorZ * kView, right * kMirrorZ)->under(range, !reversed),
                  camera);
    }
    // Mostly to one side: there, however depth is compared.
    const glm::mat4 ahead = glm::ortho(-3.0F, 2.0F, -1.0F, 2.0F, -0.2F, 9.0F);
    for (const bool greater : {false, true}) {
        EXPECT_FALSE(HostCamera::create(kView, ahead)->under({}, greater)->reversedDepth());
    }
}

TEST(HostCameraTest, ShiftsOfTheProjectionMoveTheEye) {
    // glFrustum, then glTranslate: an eye of two, or a pull back.
    const glm::vec3 shift(0.03F, -0.01F, -2.0F);
    const glm::mat4 moved = glm::translate(glm::mat4(1.0F), shift);
    const HostCamera camera = *HostCamera::create(kView, kPerspective * moved);
    const HostCamera like = *HostCamera::create(moved * kView, kPerspective);
    EXPECT_NEAR(glm::distance(camera.eye(), like.eye()), 0.0, 1e-5);
    EXPECT_NEAR(camera.projection()[3][2], like.projection()[3][2], 1e-5);
    EXPECT_EQ(camera.projection()[3][3], 0.0);
    EXPECT_NEAR(glm::distance(camera.viewOrigin(), glm::dvec3(3, 4, 5)), 0.0, 1e-5);
}

TEST(HostCameraTest, RefusesWhatShowsNothing) {
    const auto under = [](const glm::mat4& projection, bool zeroToOne) {
        const auto camera = HostCamera::create(kView, projection);
        return camera ? camera->under({.zeroToOne = zeroToOne}, false).status() : camera.status();
    };
    for (const glm::mat4& projection : rightHanded()) {
        EXPECT_TRUE(under(projection, false).ok());
    }
    for (const glm::mat4& projection :
         {kPerspective, glm::infinitePerspective(0.8F, 1.5F, 0.1F),
          glm::frustum(-0.1F, 0.3F, -0.2F, 0.1F, 0.1F, 50.0F), kMirrorZ * kPerspective,
          glm::ortho(-3.0F, 2.0F, -1.0F, 2.0F, 0.1F, 9.0F)}) {
        EXPECT_EQ(under(-projection, false).code(), StatusCode::InvalidCamera);
        EXPECT_NE(under(-projection, false).message().find("shows nothing"), std::string::npos);
    }
    // Reversed with an infinite far plane, negated: depth from -1 to 0, which [0,1] has nothing of.
    glm::mat4 modern = kPerspective;
    modern[2][2] = 0.0F;
    modern[3][2] = 0.1F;
    EXPECT_TRUE(under(-modern, false).ok());
    EXPECT_EQ(under(-modern, true).code(), StatusCode::InvalidCamera);
}

TEST(HostCameraTest, RefusesWhatIsNoUprightView) {
    const auto refuses = [](int column, int row, float value) {
        glm::mat4 projection = kPerspective;
        projection[column][row] = value;
        EXPECT_EQ(codeOf(kView, projection), StatusCode::InvalidCamera) << column << ' ' << row;
    };
    refuses(0, 2, 0.1F); // an oblique near plane
    refuses(0, 3, 0.1F); // a third vanishing point
    refuses(1, 0, 0.1F); // skewed
    refuses(0, 0, 0.0F); // flat
    refuses(3, 2, 0.0F); // without depth
    refuses(2, 3, 0.0F); // without w
}

/// A point's window position and depth, by OpenGL's own rules, lead back to the point.
TEST(HostCameraTest, FindsTheSurfaceBehindAPixel) {
    const glm::ivec2 size(300, 200);
    std::vector<glm::mat4> projections = rightHanded();
    const glm::mat4 quarterTurn{{0, 1, 0, 0}, {-1, 0, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
    const glm::mat4 pulledBack = glm::translate(glm::mat4(1.0F), {0.2F, 0.1F, -2.0F});
    for (const glm::mat4& projection : rightHanded()) {
        for (const glm::mat4& other :
             {kMirrorZ, scaled(-1, 1, 1), scaled(1, -1, -1), quarterTurn, pulledBack}) {
            projections.push_back(3.0F * projection * other);
        }
    }
    for (const glm::mat4& projection : projections) {
        const auto camera = HostCamera::create(kView, projection)->under({}, false);
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
                const glm::dvec4 nearer = p + glm::dmat4(projection) * glm::dmat4(kView) *
                                                  glm::dvec4(0.01 * surface.viewer, 0.0);
                EXPECT_EQ(nearer.z / nearer.w > p.z / p.w, camera->reversedDepth());
            }
        }
    }
}

} // namespace
} // namespace aolib
