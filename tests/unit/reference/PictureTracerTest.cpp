#include "reference/PictureTracer.h"

#include <cmath>
#include <limits>

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "TestScenes.h"
#include "reference/ClosedForms.h"

namespace aolib {
namespace {

using test::sceneOf;
using test::tracing;

const glm::dvec3 skywards(0.0, 1.0, 0.0);

/// 8 x 6 pixels from (0, 0, 5) towards the origin.
PictureCamera cameraOf(const glm::dmat4& projection) {
    return {glm::lookAt(glm::dvec3(0, 0, 5), glm::dvec3(0), skywards), projection, 8, 6};
}

glm::dmat4 perspective() {
    return glm::perspective(0.8, 8.0 / 6.0, 0.1, 100.0);
}

PictureSettings settingsOf(const TraceSettings& trace) {
    PictureSettings settings;
    settings.trace = trace;
    settings.surfaces = true;
    return settings;
}

Picture pictureOf(const RayScene& scene, const PictureCamera& camera,
                  const PictureSettings& settings) {
    Result<Picture> picture = tracePicture(scene, camera, settings);
    EXPECT_TRUE(picture) << picture.status().message();
    EXPECT_TRUE(picture->complete);
    return *picture;
}

/// A quad in z = 0 that fills the right half of the upper half of every view along -z.
TriangleMesh upperRightQuad() {
    TriangleMesh mesh;
    test::addQuad(mesh, {0, 0, 0}, {50, 0, 0}, {0, 50, 0});
    return mesh;
}

void expectUpperRight(const Picture& picture) {
    for (int y = 0; y < 6; ++y) {
        for (int x = 0; x < 8; ++x) {
            const auto pixel = static_cast<std::size_t>(8 * y + x);
            const bool covered = x >= 4 && y >= 3;
            EXPECT_EQ(picture.visibility[pixel], covered ? 1.0F : -1.0F) << x << ", " << y;
            EXPECT_NEAR(picture.depth[pixel], covered ? 5.0F : -1.0F, 1e-5F) << x << ", " << y;
            EXPECT_EQ(picture.normal[pixel], glm::vec3(0, 0, covered ? 1 : 0));
        }
    }
}

/// Projects the traced positions: they must land on the centres of their pixels.
void expectPixelCentres(const Picture& picture, const PictureCamera& camera) {
    int covered = 0;
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            const auto pixel = static_cast<std::size_t>(picture.width * y + x);
            if (picture.visibility[pixel] < 0.0F) {
                continue;
            }
            const glm::dvec4 clip = camera.projection * camera.view *
                                    glm::dvec4(glm::dvec3(picture.position[pixel]), 1.0);
            EXPECT_NEAR((clip.x / clip.w * 0.5 + 0.5) * picture.width, x + 0.5, 1e-4);
            EXPECT_NEAR((clip.y / clip.w * 0.5 + 0.5) * picture.height, y + 0.5, 1e-4);
            ++covered;
        }
    }
    EXPECT_GT(covered, 0);
}

TEST(PictureTracer, RowsRunFromTheBottomInEveryProjection) {
    const RayScene scene = sceneOf(upperRightQuad());
    for (const glm::dmat4& projection :
         {perspective(), glm::infinitePerspective(0.8, 8.0 / 6.0, 0.1),
          glm::ortho(-4.0, 4.0, -3.0, 3.0, 0.1, 100.0)}) {
        const PictureCamera camera = cameraOf(projection);
        const Picture picture = pictureOf(scene, camera, settingsOf(tracing(16)));
        expectUpperRight(picture);
        expectPixelCentres(picture, camera);
    }
}

TEST(PictureTracer, OffCentreProjection) {
    const RayScene scene = sceneOf(upperRightQuad());
    const PictureCamera camera = cameraOf(glm::frustum(-0.01, 0.09, -0.04, 0.02, 0.1, 100.0));
    expectPixelCentres(pictureOf(scene, camera, settingsOf(tracing(16))), camera);
}

TEST(PictureTracer, NearAndFarPlanesClipTheView) {
    const RayScene scene = sceneOf(upperRightQuad());
    const PictureSettings settings = settingsOf(tracing(16));
    for (const bool orthographic : {false, true}) {
        const auto covered = [&](double near, double far) {
            const glm::dmat4 projection = orthographic
                                              ? glm::ortho(-4.0, 4.0, -3.0, 3.0, near, far)
                                              : glm::perspective(0.8, 8.0 / 6.0, near, far);
            return pictureOf(scene, cameraOf(projection), settings).visibility.back() >= 0.0F;
        };
        EXPECT_TRUE(covered(4.9, 5.1));
        EXPECT_FALSE(covered(5.1, 9.0));
        EXPECT_FALSE(covered(0.1, 4.9));
    }
}

TEST(PictureTracer, BackSidesTurnTowardsTheViewer) {
    TriangleMesh mesh;
    test::addQuad(mesh, {-50, -50, 0}, {0, 100, 0}, {100, 0, 0}); // winding faces -z
    test::addQuad(mesh, {-50, -50, -1}, {0, 100, 0}, {100, 0, 0});
    const Picture picture =
        pictureOf(sceneOf(mesh), cameraOf(perspective()), settingsOf(tracing(64)));
    EXPECT_EQ(picture.normal[0], glm::vec3(0, 0, 1));
    EXPECT_EQ(picture.visibility[0], 1.0F); // the hemisphere behind would see the second quad
}

TEST(PictureTracer, GivenNormalsAreInterpolatedAndTurned) {
    TriangleMesh mesh;
    test::addQuad(mesh, {-50, -50, 0}, {100, 0, 0}, {0, 100, 0});
    const glm::vec3 tilted = glm::normalize(glm::vec3(1, 0, 1));
    mesh.normals.assign(4, 3.0F * tilted);
    PictureSettings settings = settingsOf(tracing(4096));
    const PictureCamera camera = cameraOf(perspective());
    EXPECT_EQ(pictureOf(sceneOf(mesh), camera, settings).normal[0], glm::vec3(0, 0, 1));

    settings.normals = NormalSource::Given;
    const Picture picture = pictureOf(sceneOf(mesh), camera, settings);
    EXPECT_NEAR(glm::distance(picture.normal[0], tilted), 0.0F, 1e-6F);
    // The plane hides what lies below it: a wedge of 45 degrees of the tilted hemisphere.
    EXPECT_NEAR(picture.visibility[0], 0.5 * (1.0 + std::cos(0.7853981633974483)), 0.01);

    mesh.normals.assign(4, -tilted);
    EXPECT_NEAR(glm::distance(pictureOf(sceneOf(mesh), camera, settings).normal[0], tilted), 0.0F,
                1e-6F);
    mesh.normals.assign(4, glm::vec3(0.0F));
    EXPECT_EQ(pictureOf(sceneOf(mesh), camera, settings).normal[0], glm::vec3(0, 0, 1));
    mesh.normals.clear();
    EXPECT_EQ(pictureOf(sceneOf(mesh), camera, settings).normal[0], glm::vec3(0, 0, 1));
}

/// Every floor pixel of a view over floor and wall against the closed form; far away, too.
TEST(PictureTracer, FloorBesideAWallAgreesWithTheClosedForm) {
    for (const double away : {0.0, 1e5}) {
        SCOPED_TRACE(away);
        const glm::dvec3 offset(away, -away, away);
        const RayScene scene = sceneOf(test::floorAndWall(2.0, 1.0, offset));
        PictureCamera camera;
        camera.view =
            glm::lookAt(offset + glm::dvec3(3, 4, 2), offset + glm::dvec3(1, 0, 0), skywards);
        camera.projection = glm::perspective(0.7, 1.0, 0.1, 50.0);
        camera.width = 16;
        camera.height = 16;
        const Picture picture = pictureOf(scene, camera, settingsOf(tracing(4096)));
        double squares = 0.0;
        double count = 0.0;
        for (std::size_t i = 0; i < picture.visibility.size(); ++i) {
            if (picture.normal[i].y > 0.9F) {
                // The buffer's positions are floats, at 1e5 some 0.004 off: the distance is not.
                const double distance = std::max(1e-6, double{picture.position[i].x} - offset.x);
                const double error =
                    1.0 - double{picture.visibility[i]} - wallOcclusion(2.0, distance);
                squares += error * error;
                ++count;
            }
        }
        EXPECT_GT(count, 100.0);
        EXPECT_LT(std::sqrt(squares / count), 1.3 * picture.noise + (away > 0.0 ? 0.001 : 0.0));
        EXPECT_LT(picture.noise, 0.005);
    }
}

TEST(PictureTracer, SurfacesAreOptionalAndCancelWorks) {
    const RayScene scene = sceneOf(upperRightQuad());
    PictureSettings settings;
    settings.trace.rays = 16;
    const Picture picture = pictureOf(scene, cameraOf(perspective()), settings);
    EXPECT_TRUE(picture.depth.empty() && picture.position.empty() && picture.normal.empty());
    const Result<Picture> cancelled =
        tracePicture(scene, cameraOf(perspective()), settings, [](double) { return false; });
    ASSERT_TRUE(cancelled);
    EXPECT_FALSE(cancelled->complete);
    EXPECT_EQ(cancelled->visibility, std::vector<float>(48, -1.0F));
}

TEST(PictureTracer, BadCamerasAreRefused) {
    const RayScene scene = sceneOf({});
    const auto code = [&](const PictureCamera& camera) {
        return tracePicture(scene, camera, {}).status().code();
    };
    PictureCamera camera = cameraOf(perspective());
    EXPECT_EQ(code(camera), StatusCode::Ok);
    camera.width = 0;
    EXPECT_EQ(code(camera), StatusCode::InvalidCamera);
    camera.width = 65537;
    EXPECT_EQ(code(camera), StatusCode::InvalidCamera);
    camera = cameraOf(glm::dmat4(0.0));
    EXPECT_EQ(code(camera), StatusCode::InvalidCamera);
    camera = cameraOf(perspective());
    camera.view[3][0] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(code(camera), StatusCode::InvalidCamera);
    PictureSettings settings;
    settings.trace.radius = -1.0;
    EXPECT_EQ(tracePicture(scene, cameraOf(perspective()), settings).status().code(),
              StatusCode::InvalidOption);
}

} // namespace
} // namespace aolib
