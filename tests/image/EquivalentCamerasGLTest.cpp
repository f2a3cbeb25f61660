// Two matrices that draw the same pixels shade them the same, to the bit: a left-handed camera, or
// a projection of another scale, against its right-handed equivalent.
#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <aolib/RayTracing.h>
#include <glm/gtc/matrix_transform.hpp>

#include "CoreContexts.h"
#include "HostKinds.h"
#include "WhiteHost.h"
#include "host/HostFramebuffer.h"
#include "host/ModelScene.h"

namespace aolib::test {

namespace {

constexpr int kMostEqualFrames = 40;

/// Quick: what is compared is not how good it is.
Options quick(Estimator estimator) {
    Options options;
    options.estimator = estimator;
    options.frameBudget = 0.0F;
    options.radius = 1.5F;
    options.cubeMaps.faceSize = 64;
    options.cubeMaps.place = false;
    options.horizonSplit = {.directions = 2, .steps = 2};
    options.layeredIntervals = {.slices = 2, .steps = 3};
    options.rayTraced.rays = 64;
    return options;
}

/// Whatever a host can look at.
struct Shown {
    std::vector<float> visibility;
    std::vector<std::uint8_t> colours;
    float coverage = -1.0F;
    std::size_t repaired = 0;
    bool operator==(const Shown&) const = default;
};

class EquivalentCamerasGLTest : public GLTest {
protected:
    void SetUp() override {
        GLTest::SetUp();
        if (IsSkipped() || HasFatalFailure()) {
            return;
        }
        host_.emplace(gl, boxes());
        auto framebuffer = host::HostFramebuffer::create(gl, {kWidth, kHeight});
        ASSERT_TRUE(framebuffer.ok()) << framebuffer.status().message();
        framebuffer_.emplace(std::move(*framebuffer));
    }
    void TearDown() override {
        framebuffer_.reset();
        host_.reset();
        GLTest::TearDown();
    }

    bool drawable(const CameraKind& camera) const {
        return gl.capabilities.clipControl || (!camera.zeroToOne && !camera.upperLeft);
    }

    AoStatus frame(AmbientOcclusion& ao, const CameraKind& camera) {
        framebuffer_->bind();
        gl.DepthRange(camera.depthRange[0], camera.depthRange[1]);
        if (gl.capabilities.clipControl) {
            gl.ClipControl(camera.upperLeft ? GL_UPPER_LEFT : GL_LOWER_LEFT,
                           camera.zeroToOne ? GL_ZERO_TO_ONE : GL_NEGATIVE_ONE_TO_ONE);
        }
        AoStatus status = ao.aoSetCamera(glm::mat4(viewOf(camera)), glm::mat4(camera.projection));
        if (status) {
            status = ao.aoDrawBegin();
            host_->draw(camera, 1.0F);
            const glm::vec3 eye(eyeOf(camera));
            status = ao.aoDrawEnd(eye.x, eye.y, eye.z);
        }
        gl.Disable(GL_DEPTH_TEST);
        gl.DepthRange(0.0, 1.0);
        if (gl.capabilities.clipControl) {
            gl.ClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
        }
        return status;
    }

    /// What a view at rest becomes, from the beginning.
    Shown show(AmbientOcclusion& ao, const CameraKind& camera) {
        EXPECT_TRUE(ao.clear().ok());
        if (ao.options().backbone == Backbone::Cubemapped) {
            EXPECT_TRUE(ao.addCubeMap(glm::vec3(kEye) + glm::vec3(0.3F)).ok());
        }
        for (int i = 0; i < kMostEqualFrames && (i < 4 || !ao.statistics().converged); ++i) {
            const AoStatus status = frame(ao, camera);
            EXPECT_TRUE(status.ok()) << status.message();
            gl.Finish();
        }
        const Statistics statistics = ao.statistics();
        Shown shown{.visibility = {},
                    .colours = framebuffer_->readColour()->pixels,
                    .coverage = statistics.coverage,
                    .repaired = statistics.pixelsRefined};
        shown.visibility = ao.readVisibility()->visibility;
        return shown;
    }

    AmbientOcclusion make(const Options& options) {
        auto ao = AmbientOcclusion::create(loader, options);
        EXPECT_TRUE(ao.ok()) << ao.status().message();
        EXPECT_TRUE(host::describeScene(*ao, boxes(), host::SceneNormals::Geometric).ok());
        ao->setTexelTracer(std::move(*createTexelTracer(2)));
        return std::move(*ao);
    }

    /// Both cameras with these options. @return what was shown.
    Shown expectEqual(const Options& options, const CameraKind& camera, const CameraKind& other,
                      const std::string& name) {
        AmbientOcclusion ao = make(options);
        Shown plain = show(ao, camera);
        const Shown shown = show(ao, other);
        EXPECT_EQ(shown.visibility, plain.visibility) << name;
        EXPECT_EQ(shown.colours, plain.colours) << name;
        EXPECT_EQ(shown.coverage, plain.coverage) << name;
        EXPECT_EQ(shown.repaired, plain.repaired) << name;
        const auto dark = [](float w) { return w >= 0.0F && w < 0.9F; };
        EXPECT_TRUE(std::any_of(plain.visibility.begin(), plain.visibility.end(), dark))
            << name << ": the test would see nothing";
        return plain;
    }

    std::optional<WhiteHost> host_;
    std::optional<host::HostFramebuffer> framebuffer_;
};

TEST_P(EquivalentCamerasGLTest, LeftHandedIsRightHandedForAllDepthConventions) {
    Options options = quick(Estimator::HorizonSplit);
    for (const Backbone backbone : {Backbone::Cubemapped, Backbone::ScreenSpace}) {
        options.backbone = backbone;
        for (const char* name :
             {"perspective", "off-centre", "orthographic", "infinite far", "reversed", "[0,1]",
              "reversed, [0,1], infinite far", "y flipped", "upper left", "depth range reversed"}) {
            const CameraKind camera = cameraKinds().at(name);
            if (drawable(camera)) {
                expectEqual(options, camera, leftHanded(camera), name);
            }
        }
    }
}

TEST_P(EquivalentCamerasGLTest, LeftHandedIsRightHandedForAllEstimators) {
    const CameraKind camera = cameraKinds().at("perspective");
    for (const Estimator estimator :
         {Estimator::HorizonSplit, Estimator::LayeredIntervals, Estimator::RayTraced}) {
        for (const ProjectionMethod method :
             {ProjectionMethod::SinglePass, ProjectionMethod::PingPong}) {
            Options options = quick(estimator);
            options.cubeMaps.projection = method;
            const Shown shown =
                expectEqual(options, camera, leftHanded(camera, 2.0), "an estimator");
            EXPECT_EQ(shown.repaired > 0U, estimator != Estimator::HorizonSplit);
            EXPECT_GT(shown.coverage, 0.9F);
        }
    }
    Options options = quick(Estimator::LayeredIntervals);
    options.backbone = Backbone::ScreenSpace;
    expectEqual(options, camera, leftHanded(camera, 2.0), "screen space");
}

TEST_P(EquivalentCamerasGLTest, LeftHandedIsRightHandedInAllDebugViews) {
    const CameraKind camera = cameraKinds().at("perspective");
    for (int view = 1; view <= static_cast<int>(DebugView::Normals); ++view) {
        Options options = quick(Estimator::HorizonSplit);
        options.debugView = static_cast<DebugView>(view);
        options.cubeMaps.outlines = true;
        expectEqual(options, camera, leftHanded(camera), "view " + std::to_string(view));
    }
}

/// Nothing but what depth is compared and cleared by tells where an orthographic camera looks that
/// shows what is on both sides of its eye.
TEST_P(EquivalentCamerasGLTest, OrthographicAroundTheEyeLooksWhereDepthSays) {
    const Options options = quick(Estimator::HorizonSplit);
    CameraKind camera = cameraKinds().at("orthographic");
    camera.projection = glm::orthoRH_NO(-4.0, 4.0, -2.5, 2.5, -20.0, 40.0);
    expectEqual(options, camera, leftHanded(camera), "around the eye");
    CameraKind reversed = camera;
    reversed.projection = glm::scale(glm::dmat4(1.0), {1.0, 1.0, -1.0}) * reversed.projection;
    reversed.reversed = true;
    expectEqual(options, reversed, leftHanded(reversed), "around the eye, reversed");
    camera.depthRange = {1.0, 0.0};
    camera.reversed = true;
    expectEqual(options, camera, leftHanded(camera), "around the eye, depth range reversed");
    reversed.depthRange = {1.0, 0.0};
    reversed.reversed = false;
    expectEqual(options, reversed, leftHanded(reversed), "around the eye, both reversed");
}

TEST_P(EquivalentCamerasGLTest, WhatShowsNothingIsRefused) {
    AmbientOcclusion ao = make(quick(Estimator::HorizonSplit));
    for (const char* name : {"perspective", "orthographic", "reversed"}) {
        CameraKind camera = cameraKinds().at(name);
        EXPECT_TRUE(frame(ao, camera).ok()) << name;
        camera.projection = -camera.projection;
        const AoStatus status = frame(ao, camera);
        EXPECT_EQ(status.code(), StatusCode::InvalidCamera) << name;
        EXPECT_NE(status.message().find("shows nothing"), std::string::npos) << status.message();
    }
}

AOLIB_FOR_CORE_CONTEXTS(EquivalentCamerasGLTest);

} // namespace

} // namespace aolib::test
