// Hosts that draw what occludes by themselves: setSceneRenderer().
#include <cmath>
#include <stdexcept>

#include "HostileRenderer.h"
#include "SmallScene.h"

namespace aolib {
namespace {

Options radiusOne(Estimator estimator) {
    Options options = atOnce();
    options.estimator = estimator;
    options.radius = 1.0F;
    options.cubeMaps.faceSize = 128;
    return options;
}

const glm::vec3 kMin{-8, 0, -8};
const glm::vec3 kMax{8, 2, 8};

/// A host whose scene is drawn, never described.
class Drawn {
public:
    Drawn(const gl::Functions& gl, const ProcAddressLoader& loader, const Model& model,
          const Options& options)
        : host_(gl, loader, Model{}, options) {
        renderer_.emplace(std::move(*host::HostRenderer::create(gl, model)));
        host_.renderer() = std::move(*host::HostRenderer::create(gl, model));
        EXPECT_TRUE(host_.ao()
                        .setSceneRenderer(
                            [this](const FaceView& view) {
                                ++faces;
                                if (before) {
                                    before(view);
                                }
                                renderer_->draw(view.view, view.projection);
                                if (after) {
                                    after(view);
                                }
                            },
                            kMin, kMax)
                        .ok());
        host_.lookAt({4, 4, 6}, {0, 0.5F, 0});
    }
    SmallHost& operator*() { return host_; }
    SmallHost* operator->() { return &host_; }

    int faces = 0; ///< drawn so far
    std::function<void(const FaceView&)> before;
    std::function<void(const FaceView&)> after;

private:
    SmallHost host_;
    std::optional<host::HostRenderer> renderer_;
};

class SceneRendererGLTest : public GLTest {
protected:
    static double difference(const std::vector<float>& a, const std::vector<float>& b) {
        double sum = 0.0;
        EXPECT_EQ(a.size(), b.size());
        for (std::size_t i = 0; i < a.size(); ++i) {
            sum += std::pow(a[i] - b[i], 2);
        }
        return std::sqrt(sum / static_cast<double>(a.size()));
    }
};

TEST_P(SceneRendererGLTest, SeesWhatTrianglesWouldShow) {
    for (const Estimator estimator : {Estimator::HorizonSplit, Estimator::LayeredIntervals}) {
        SmallHost described(gl, loader, boxOnFloor(), radiusOne(estimator));
        Drawn drawn(gl, loader, boxOnFloor(), radiusOne(estimator));
        const glm::vec3 at(3, 3, 4);
        const auto a = described.ao().addCubeMap(at);
        const auto b = drawn->ao().addCubeMap(at);
        ASSERT_TRUE(a.ok() && b.ok()) << b.status().message();
        EXPECT_GE(drawn.faces, 4);
        const CubeMapImage expected = *described.ao().readCubeMap(*a);
        const CubeMapImage found = *drawn->ao().readCubeMap(*b);
        std::size_t differ = 0;
        for (std::size_t i = 0; i < found.distance.size(); ++i) {
            const float tolerance = 0.01F * std::abs(expected.distance[i]);
            differ += std::abs(found.distance[i] - expected.distance[i]) > tolerance ? 1 : 0;
        }
        EXPECT_LT(differ, found.distance.size() / 200) << "at silhouettes alone";
        // One layer in place of all: what is hidden behind the box is not known.
        const std::vector<float> open(found.visibility.size(), 1.0F);
        EXPECT_LT(difference(found.visibility, expected.visibility), 0.01);
        EXPECT_LT(difference(found.visibility, expected.visibility),
                  0.5 * difference(open, expected.visibility));
        ASSERT_TRUE(drawn->frame().ok()) << drawn->ao().lastStatus().message();
        EXPECT_GT(drawn->visibilityAt({4, 0, 1}), 0.95F);
        EXPECT_LT(drawn->visibilityAt({1.1F, 0, 0}), 0.9F);
    }
}

TEST_P(SceneRendererGLTest, ViewsAreThoseOfTheFaces) {
    Drawn drawn(gl, loader, boxOnFloor(), radiusOne(Estimator::HorizonSplit));
    std::vector<FaceView> views;
    drawn.before = [&](const FaceView& view) {
        views.push_back(view);
        GLint viewport[4] = {};
        gl.GetIntegerv(GL_VIEWPORT, viewport);
        EXPECT_EQ(glm::ivec2(viewport[2], viewport[3]), view.size);
        EXPECT_EQ(gl.CheckFramebufferStatus(GL_FRAMEBUFFER),
                  static_cast<GLenum>(GL_FRAMEBUFFER_COMPLETE));
        EXPECT_EQ(gl.IsEnabled(GL_DEPTH_TEST), GL_TRUE);
    };
    const glm::vec3 at(3, 1, 4); // among the scene: all faces see some of its box
    ASSERT_TRUE(drawn->ao().addCubeMap(at).ok());
    ASSERT_EQ(views.size(), 6U);
    for (const FaceView& view : views) {
        EXPECT_EQ(view.position, at);
        EXPECT_EQ(view.size, glm::ivec2(128));
        EXPECT_NEAR(glm::determinant(glm::mat3(view.view)), 1.0F, 1e-5F) << "no mirror";
        EXPECT_NEAR(glm::length(glm::vec3(view.view * glm::vec4(at, 1.0F))), 0.0F, 1e-5F);
    }
}

TEST_P(SceneRendererGLTest, WhatTheRendererLeavesBehindHarmsNothing) {
    for (const Estimator estimator : {Estimator::HorizonSplit, Estimator::LayeredIntervals}) {
        Drawn drawn(gl, loader, boxOnFloor(), radiusOne(estimator));
        const auto image = [&] {
            const auto id = drawn->ao().addCubeMap({3, 3, 4});
            EXPECT_TRUE(id.ok()) << id.status().message();
            CubeMapImage read = *drawn->ao().readCubeMap(*id);
            EXPECT_TRUE(drawn->ao().clear().ok());
            return read;
        };
        const CubeMapImage expected = image();
        const HostileRenderer hostile(gl);
        drawn.after = std::cref(hostile);
        drawn.before = [&](const FaceView&) { // undo what a renderer cannot draw with
            EXPECT_EQ(gl.IsEnabled(GL_RASTERIZER_DISCARD), GL_FALSE);
        };
        const CubeMapImage found = image();
        EXPECT_EQ(found.visibility, expected.visibility);
        EXPECT_EQ(found.distance, expected.distance);
    }
}

TEST_P(SceneRendererGLTest, ChangesAreDrawnAgainWhereTheyAreSeen) {
    Drawn drawn(gl, loader, boxOnFloor(), radiusOne(Estimator::HorizonSplit));
    ASSERT_TRUE(drawn->frame().ok());
    const int first = drawn.faces;
    EXPECT_GT(first, 0);
    ASSERT_TRUE(drawn->frame().ok());
    EXPECT_EQ(drawn.faces, first) << "kept";
    ASSERT_TRUE(drawn->ao().aoSceneChanged({2, 0, 2}, {3, 1, 3}).ok());
    ASSERT_TRUE(drawn->frame().ok());
    EXPECT_EQ(drawn.faces, 2 * first) << "drawn again";
    ASSERT_TRUE(drawn->ao().aoSceneChanged({2, -9, 2}, {3, -8, 3}).ok());
    ASSERT_TRUE(drawn->frame().ok());
    EXPECT_EQ(drawn.faces, 2 * first) << "below the floor: out of viewpoint";
    ASSERT_TRUE(drawn->ao().setSceneRenderer({}, kMin, kMax).ok());
    ASSERT_TRUE(drawn->frame().ok());
    EXPECT_EQ(drawn.faces, 2 * first) << "taken away";
}

TEST_P(SceneRendererGLTest, WorksWithinABudget) {
    Options options = radiusOne(Estimator::LayeredIntervals);
    options.frameBudget = 50.0F;
    Drawn drawn(gl, loader, boxOnFloor(), options);
    for (int i = 0; i < 400 && !(i > 2 && drawn->ao().statistics().converged); ++i) {
        ASSERT_TRUE(drawn->frame().ok()) << drawn->ao().lastStatus().message();
        gl.Finish();
    }
    EXPECT_TRUE(drawn->ao().statistics().converged);
    EXPECT_LT(drawn->visibilityAt({1.1F, 0, 0}), 0.9F);
}

TEST_P(SceneRendererGLTest, ExceptionsAndCallsWithinAreRefused) {
    Drawn drawn(gl, loader, boxOnFloor(), radiusOne(Estimator::HorizonSplit));
    AmbientOcclusion& ao = drawn->ao();
    drawn.before = [](const FaceView&) { throw std::runtime_error("no disc in drive"); };
    const AoStatus thrown = ao.addCubeMap({3, 3, 4}).status();
    EXPECT_EQ(thrown.code(), StatusCode::CallbackFailed);
    EXPECT_NE(thrown.message().find("no disc in drive"), std::string::npos);
    drawn.before = [](const FaceView&) { throw 42; };
    EXPECT_EQ(drawn->frame().code(), StatusCode::CallbackFailed);
    EXPECT_TRUE(ao.cubeMaps().empty());
    std::vector<StatusCode> codes;
    drawn.before = [&](const FaceView&) {
        Options other = ao.options();
        other.backbone = Backbone::ScreenSpace;
        codes = {ao.addCubeMap({1, 3, 4}).status().code(),
                 ao.removeCubeMap(CubeMapId{1}).code(),
                 ao.clear().code(),
                 ao.setOptions(other).code(),
                 ao.readVisibility().status().code(),
                 ao.readCubeMap(CubeMapId{1}).status().code(),
                 ao.aoDrawBegin().code(),
                 ao.aoDrawEnd(4, 4, 6).code(),
                 ao.aoApply({}, {4, 4, 6}).status().code(),
                 ao.setSceneRenderer({}, kMin, kMax).code()};
        ao.setTexelTracer({});
    };
    EXPECT_TRUE(drawn->frame().ok()) << ao.lastStatus().message();
    EXPECT_EQ(codes, std::vector<StatusCode>(10, StatusCode::InvalidCallOrder));
    drawn.before = {};
    EXPECT_TRUE(drawn->frame().ok()) << ao.lastStatus().message();
}

TEST_P(SceneRendererGLTest, RefusesBoxesThatAreNone) {
    SmallHost host(gl, loader, Model{}, radiusOne(Estimator::HorizonSplit));
    const auto nothing = [](const FaceView&) {};
    const float nan = std::nanf("");
    EXPECT_EQ(host.ao().aoSceneChanged(kMin, kMax).code(), StatusCode::NoScene);
    EXPECT_EQ(host.ao().setSceneRenderer(nothing, kMax, kMin).code(), StatusCode::InvalidPosition);
    EXPECT_EQ(host.ao().setSceneRenderer(nothing, kMin, {1, nan, 1}).code(),
              StatusCode::InvalidPosition);
    EXPECT_EQ(host.ao().addCubeMap({0, 1, 0}).status().code(), StatusCode::NoScene);
    EXPECT_TRUE(host.ao().setSceneRenderer(nothing, kMin, kMax).ok());
    EXPECT_TRUE(host.ao().addCubeMap({0, 1, 0}).ok()) << "a renderer that draws nothing";
    Options traced = host.ao().options();
    traced.estimator = Estimator::RayTraced;
    EXPECT_TRUE(host.ao().setOptions(traced).ok());
    EXPECT_NE(host.frame().code(), StatusCode::Ok) << "rays need triangles";
}

AOLIB_FOR_ALL_CONTEXTS(SceneRendererGLTest);

} // namespace
} // namespace aolib
