// Every misuse of the facade has its code, and harms nothing that was there.
#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <string_view>

#include <aolib/RayTracing.h>

#include "SmallScene.h"
#include "gl/RenderToTexture2D.h"

namespace aolib {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

Model boxModel() {
    Model model;
    addBox(model, {-1, -1, -1}, {1, 1, 1});
    return model;
}

class FacadeGLTest : public GLTest {
protected:
    AmbientOcclusion make(const Options& options = atOnce()) {
        auto ao = AmbientOcclusion::create(loader, options);
        EXPECT_TRUE(ao.ok()) << ao.status().message();
        return std::move(*ao);
    }
};

TEST_P(FacadeGLTest, CreateRefusesWhatCannotWork) {
    EXPECT_EQ(AmbientOcclusion::create({}).status().code(), StatusCode::NoContext);
    EXPECT_EQ(
        AmbientOcclusion::create([](const char*) -> void* { return nullptr; }).status().code(),
        StatusCode::NoContext);
    Options options;
    options.contrast = 2.0F;
    EXPECT_EQ(AmbientOcclusion::create(loader, options).status().code(), StatusCode::InvalidOption);
    const auto holed = [this](const char* name) -> void* {
        return std::string_view(name) == "glDrawArrays" ? nullptr : loader(name);
    };
    const AoStatus missing = AmbientOcclusion::create(holed).status();
    EXPECT_EQ(missing.code(), StatusCode::MissingCapability);
    EXPECT_NE(missing.message().find("glDrawArrays"), std::string::npos);
}

/// The functions that opengl32.dll exports and wglGetProcAddress therefore does not know.
bool isOfGl11(std::string_view name) {
    constexpr std::array<std::string_view, 12> kSome{
        "glGetString",    "glGetIntegerv",    "glGetFloatv", "glDrawArrays",
        "glDrawElements", "glEnable",         "glDisable",   "glViewport",
        "glBindTexture",  "glDeleteTextures", "glDepthFunc", "glDepthMask"};
    return std::find(kSome.begin(), kSome.end(), name) != kSome.end();
}

TEST_P(FacadeGLTest, CreateWithoutGl11_NamesFunctionsAndNoContext) {
    for (const std::intptr_t absent : {0, 1, 2, 3, -1}) {
        const auto wgl = [&](const char* name) -> void* {
            return isOfGl11(name) ? reinterpret_cast<void*>(absent) : loader(name);
        };
        const AoStatus status = AmbientOcclusion::create(wgl).status();
        EXPECT_EQ(status.code(), StatusCode::MissingCapability) << absent;
        EXPECT_NE(status.message().find("glGetString"), std::string::npos) << status.message();
        EXPECT_NE(status.message().find("opengl32.dll"), std::string::npos) << status.message();
        EXPECT_EQ(status.message().find("context"), std::string::npos) << status.message();
    }
}

TEST_P(FacadeGLTest, AddressesThatWglReturnsForNothing_CountAsMissing) {
    for (const std::intptr_t absent : {1, 2, 3, -1}) {
        const auto nothing = [&](const char*) { return reinterpret_cast<void*>(absent); };
        EXPECT_EQ(AmbientOcclusion::create(nothing).status().code(), StatusCode::NoContext);
        const auto holed = [&](const char* name) {
            return std::string_view(name) == "glGenQueries" ? reinterpret_cast<void*>(absent)
                                                            : loader(name);
        };
        const AoStatus status = AmbientOcclusion::create(holed).status();
        EXPECT_EQ(status.code(), StatusCode::MissingCapability);
        EXPECT_NE(status.message().find("glGenQueries"), std::string::npos) << status.message();
    }
}

TEST_P(FacadeGLTest, RefusedOptionsChangeNothing) {
    AmbientOcclusion ao = make();
    Options options = ao.options();
    options.cubeMaps.faceSize = 1;
    EXPECT_EQ(ao.setOptions(options).code(), StatusCode::InvalidOption);
    EXPECT_EQ(ao.options().cubeMaps.faceSize, 512);
    EXPECT_EQ(ao.lastStatus().code(), StatusCode::InvalidOption);
}

TEST_P(FacadeGLTest, TheSinkHearsEveryFailure) {
    AmbientOcclusion ao = make();
    std::vector<StatusCode> heard;
    ao.setMessageSink([&](const AoStatus& status) { heard.push_back(status.code()); });
    (void)ao.meshEnd();
    (void)ao.removeMesh(MeshId{77});
    (void)ao.meshBegin();
    EXPECT_EQ(heard, (std::vector{StatusCode::InvalidCallOrder, StatusCode::UnknownMesh}));
    EXPECT_EQ(ao.lastStatus().code(), StatusCode::UnknownMesh);
}

TEST_P(FacadeGLTest, AutomaticTakesTheEstimatorThatSceneAndTracerAllow) {
    Options options;
    options.cubeMaps.faceSize = 16;
    AmbientOcclusion ao = make(options);
    const std::vector<glm::vec3> positions{{-1, 0, -1}, {1, 0, -1}, {0, 0, 1}};
    const std::vector<glm::vec3> normals(3, glm::vec3(0, 1, 0));
    const std::vector<std::uint32_t> indices{0, 1, 2};
    const auto inForce = [&] {
        EXPECT_TRUE(ao.addCubeMap({0, 1, 0}).ok()) << ao.lastStatus().message();
        EXPECT_EQ(ao.options().estimator, Estimator::Automatic);
        return ao.statistics().estimator;
    };
    EXPECT_TRUE(ao.addMesh({positions, {}, indices}).ok());
    EXPECT_EQ(inForce(), Estimator::LayeredIntervals) << "without a tracer";
    ao.setTexelTracer(std::move(*createTexelTracer(1)));
    EXPECT_EQ(inForce(), Estimator::RayTraced);
    const Result<MeshId> smooth = ao.addMesh({positions, normals, indices});
    ASSERT_TRUE(smooth.ok());
    EXPECT_EQ(inForce(), Estimator::RayTraced) << "with normals of the host's own, too";
    EXPECT_TRUE(ao.removeMesh(*smooth).ok());
    EXPECT_TRUE(ao.setSceneRenderer([](const FaceView&) {}, {-1, -1, -1}, {1, 1, 1}).ok());
    EXPECT_EQ(inForce(), Estimator::LayeredIntervals) << "with a scene renderer";
    EXPECT_TRUE(ao.setSceneRenderer(nullptr, {}, {}).ok());
    options.estimator = Estimator::HorizonSplit;
    EXPECT_TRUE(ao.setOptions(options).ok());
    EXPECT_EQ(ao.statistics().estimator, Estimator::HorizonSplit);
    options.estimator = Estimator::Automatic;
    options.backbone = Backbone::ScreenSpace;
    EXPECT_TRUE(ao.setOptions(options).ok());
    EXPECT_EQ(ao.statistics().estimator, Estimator::LayeredIntervals) << "in screen space";
}

TEST_P(FacadeGLTest, SceneDefinitionAsInTheThesis) {
    AmbientOcclusion ao = make();
    EXPECT_TRUE(ao.meshBegin().ok());
    EXPECT_TRUE(ao.aoVertex3f(0, 0, 0).ok());
    EXPECT_TRUE(ao.aoVertex3f(0, 0, 1).ok());
    EXPECT_TRUE(ao.aoVertex3f(1, 0, 1).ok());
    EXPECT_TRUE(ao.aoVertex3f(1, 0, 0).ok());
    EXPECT_TRUE(ao.aoBegin(AO_TRIANGLES).ok());
    for (const unsigned index : {0U, 1U, 2U, 0U, 2U, 3U}) {
        EXPECT_TRUE(ao.aoVertexIndex(index).ok());
    }
    EXPECT_TRUE(ao.aoEnd().ok());
    const Result<MeshId> id = ao.meshEnd();
    ASSERT_TRUE(id.ok());
    EXPECT_TRUE(ao.moveMesh(*id, glm::mat4(2.0F)).ok());
    EXPECT_TRUE(ao.removeMesh(*id).ok());
    EXPECT_EQ(ao.removeMesh(*id).code(), StatusCode::UnknownMesh);
}

TEST_P(FacadeGLTest, CubeMapsNeedASceneAndAPlace) {
    AmbientOcclusion ao = make();
    EXPECT_EQ(ao.addCubeMap({0, 0, 0}).status().code(), StatusCode::NoScene);
    const std::vector<glm::vec3> positions{{-1, 0, -1}, {1, 0, -1}, {0, 0, 1}};
    const std::vector<std::uint32_t> indices{0, 1, 2};
    ASSERT_TRUE(ao.addMesh({positions, {}, indices}).ok());
    EXPECT_EQ(ao.addCubeMap({kNaN, 0, 0}).status().code(), StatusCode::InvalidPosition);
    const Result<CubeMapId> id = ao.addCubeMap({0, 1, 0});
    ASSERT_TRUE(id.ok()) << id.status().message();
    EXPECT_EQ(ao.cubeMaps().size(), 1U);
    EXPECT_EQ(ao.removeCubeMap(CubeMapId{99}).code(), StatusCode::UnknownCubeMap);
    EXPECT_EQ(ao.readCubeMap(CubeMapId{99}).status().code(), StatusCode::UnknownCubeMap);
    EXPECT_EQ(ao.cubeMaps().size(), 1U);
    EXPECT_TRUE(ao.removeCubeMap(*id).ok());
    EXPECT_TRUE(ao.cubeMaps().empty());
    EXPECT_TRUE(ao.clear().ok());
}

TEST_P(FacadeGLTest, ACubeMapTooLargeForTheContextIsRefused) {
    Options options = atOnce();
    options.cubeMaps.faceSize = 4096;
    AmbientOcclusion ao = make(options);
    const std::vector<glm::vec3> positions{{-1, 0, -1}, {1, 0, -1}, {0, 0, 1}};
    const std::vector<std::uint32_t> indices{0, 1, 2};
    ASSERT_TRUE(ao.addMesh({positions, {}, indices}).ok());
    if (gl.capabilities.maxTextureSize >= 6 * 4096) {
        GTEST_SKIP() << "NOT TESTED: this context takes textures of any size we ask for";
    }
    EXPECT_EQ(ao.addCubeMap({0, 1, 0}).status().code(), StatusCode::MissingCapability);
    EXPECT_TRUE(ao.cubeMaps().empty());
}

TEST_P(FacadeGLTest, ScreenSpaceKeepsNoCubeMaps) {
    Options options;
    options.backbone = Backbone::ScreenSpace;
    AmbientOcclusion ao = make(options);
    EXPECT_EQ(ao.addCubeMap({0, 0, 0}).status().code(), StatusCode::InvalidCallOrder);
    EXPECT_EQ(ao.removeCubeMap(CubeMapId{1}).code(), StatusCode::InvalidCallOrder);
    EXPECT_TRUE(ao.clear().ok());
    EXPECT_TRUE(ao.cubeMaps().empty());
}

TEST_P(FacadeGLTest, FramesComeInPairs) {
    SmallHost host(gl, loader, boxModel(), {});
    AmbientOcclusion& ao = host.ao();
    EXPECT_EQ(ao.readVisibility().status().code(), StatusCode::InvalidCallOrder);
    host.lookAt({3, 2, 4}, {0, 0, 0});
    EXPECT_EQ(ao.aoDrawEnd(0, 0, 0).code(), StatusCode::InvalidCallOrder);
    ASSERT_TRUE(ao.aoDrawBegin().ok());
    EXPECT_EQ(ao.aoDrawBegin().code(), StatusCode::InvalidCallOrder);
    host.framebuffer().bind();
    ASSERT_TRUE(ao.aoSetCamera(host.view(), host.projection()).ok());
    EXPECT_TRUE(ao.aoDrawEnd(3, 2, 4).ok());
    EXPECT_TRUE(host.frame().ok());
    EXPECT_TRUE(ao.readVisibility().ok());
}

TEST_P(FacadeGLTest, FramesRefuseWhatTheyCannotUse) {
    SmallHost host(gl, loader, boxModel(), {});
    AmbientOcclusion& ao = host.ao();
    host.framebuffer().bind();
    const auto endAt = [&](float x) {
        EXPECT_TRUE(ao.aoDrawBegin().ok());
        return ao.aoDrawEnd(x, 0, 0).code();
    };
    if (GetParam().profile == ContextRequest::Profile::Core) {
        EXPECT_EQ(endAt(0), StatusCode::NoCamera);
        EXPECT_NE(ao.lastStatus().message().find("aoSetCamera"), std::string::npos);
    } else {
        EXPECT_EQ(endAt(5), StatusCode::InvalidCamera) << "GL's matrices are the identity";
    }
    glm::mat4 bad(1.0F);
    bad[1][1] = kNaN;
    EXPECT_EQ(ao.aoSetCamera(bad, bad).code(), StatusCode::InvalidCamera);
    host.lookAt({3, 2, 4}, {0, 0, 0});
    ASSERT_TRUE(ao.aoSetCamera(host.view(), host.projection()).ok());
    EXPECT_EQ(endAt(kNaN), StatusCode::InvalidCamera);
    gl.Viewport(0, 0, 0, 0);
    EXPECT_EQ(endAt(0), StatusCode::InvalidFramebuffer);
    gl.Viewport(0, 0, 8, 8);
    // A framebuffer without depth, and one without anything.
    const auto colourOnly =
        gl::RenderToTexture2D::create(gl, {.width = 8,
                                           .height = 8,
                                           .targets = {gl::RenderToTexture2D::Format::RGBA8},
                                           .label = "test"});
    colourOnly->bindAsTarget(0);
    EXPECT_EQ(endAt(0), StatusCode::InvalidFramebuffer);
    const auto empty = gl::generate<gl::Framebuffer>(gl, &gl::Functions::GenFramebuffers);
    gl.BindFramebuffer(GL_FRAMEBUFFER, empty.name());
    EXPECT_EQ(endAt(0), StatusCode::InvalidFramebuffer);
    takeDriverMessages(); // it says why that one is incomplete
    EXPECT_TRUE(host.frame().ok()) << "nothing was lost";
    host.framebuffer().bind();
}

TEST_P(FacadeGLTest, AnEmptySceneLeavesThePictureAlone) {
    SmallHost host(gl, loader, boxModel(), {});
    AmbientOcclusion empty = make();
    host.lookAt({3, 2, 4}, {0, 0, 0});
    host.framebuffer().bind();
    host.renderer().draw(host.view(), host.projection());
    const auto before = host.framebuffer().readColour();
    host.framebuffer().bind();
    ASSERT_TRUE(empty.aoSetCamera(host.view(), host.projection()).ok());
    ASSERT_TRUE(empty.aoDrawBegin().ok());
    EXPECT_TRUE(empty.aoDrawEnd(3, 2, 4).ok());
    EXPECT_EQ(host.framebuffer().readColour()->pixels, before->pixels);
}

TEST_P(FacadeGLTest, ABackboneIsExchangedWithTheSceneKept) {
    SmallHost host(gl, loader, boxModel(), {});
    host.lookAt({3, 2, 4}, {0, 0, 0});
    ASSERT_TRUE(host.frame().ok());
    EXPECT_EQ(host.ao().cubeMaps().size(), 1U);
    Options options = host.ao().options();
    options.backbone = Backbone::ScreenSpace;
    ASSERT_TRUE(host.ao().setOptions(options).ok());
    ASSERT_TRUE(host.frame().ok());
    EXPECT_TRUE(host.ao().cubeMaps().empty());
    options.backbone = Backbone::Cubemapped;
    ASSERT_TRUE(host.ao().setOptions(options).ok());
    ASSERT_TRUE(host.frame().ok());
    EXPECT_EQ(host.ao().cubeMaps().size(), 1U) << "the scene must still be there";
}

AOLIB_FOR_ALL_CONTEXTS(FacadeGLTest);

} // namespace
} // namespace aolib
