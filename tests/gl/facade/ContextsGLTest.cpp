// One instance and several contexts: those that share objects, those that share nothing, none.
#include <sstream>
#include <thread>
#include <utility>

#include <aolib/RayTracing.h>

#include "SmallScene.h"
#include "TwinContext.h"
#include "host/ModelScene.h"

namespace aolib {
namespace {

using Shares = TwinContext::Shares;

Options contextOptions() {
    Options options = atOnce();
    options.radius = 1.0F;
    options.horizonSplit = {.directions = 4, .steps = 4};
    options.cubeMaps.faceSize = 32;
    return options;
}

/// What a host has in one context: the framebuffer and the vertex arrays are that context's alone.
struct Place {
    Place(const gl::Functions& gl, const ProcAddressLoader& loader)
        : error(reinterpret_cast<PFNGLGETERRORPROC>(loader("glGetError"))),
          framebuffer(std::move(*host::HostFramebuffer::create(gl, {64, 36, 0}))),
          renderer(std::move(*host::HostRenderer::create(gl, boxOnFloor()))) {}

    AoStatus frame(AmbientOcclusion& ao) {
        const glm::vec3 eye(4, 4, 6);
        const glm::mat4 view = glm::lookAt(eye, glm::vec3(0, 0.5F, 0), glm::vec3(0, 1, 0));
        const glm::mat4 projection = glm::perspective(1.0F, 64.0F / 36.0F, 0.05F, 200.0F);
        framebuffer.bind();
        (void)ao.aoSetCamera(view, projection);
        const AoStatus begun = ao.aoDrawBegin();
        renderer.draw(view, projection);
        const AoStatus ended = ao.aoDrawEnd(eye.x, eye.y, eye.z);
        EXPECT_EQ(begun.code(), ended.code());
        return ended;
    }
    std::vector<std::uint8_t> picture(AmbientOcclusion& ao) {
        const AoStatus status = frame(ao);
        EXPECT_TRUE(status.ok()) << status.message();
        EXPECT_EQ(error(), static_cast<GLenum>(GL_NO_ERROR));
        return framebuffer.readColour()->pixels;
    }

    PFNGLGETERRORPROC error;
    host::HostFramebuffer framebuffer;
    host::HostRenderer renderer;
};

class ContextsGLTest : public ContextTest {
protected:
    void SetUp() override { open({ContextRequest::Api::Egl, ContextRequest::Profile::Core}); }
    void TearDown() override {
        std::istringstream messages(takeDriverMessages());
        for (std::string line; std::getline(messages, line);) {
            // Mesa compiles programs again when another context first draws with them.
            EXPECT_NE(line.find("shader variant"), std::string::npos) << line;
        }
        ContextTest::TearDown();
    }
    AmbientOcclusion make(const Options& options = contextOptions()) const {
        auto ao = AmbientOcclusion::create(loader, options);
        EXPECT_TRUE(ao.ok()) << ao.status().message();
        EXPECT_TRUE(host::describeScene(*ao, boxOnFloor(), host::SceneNormals::Geometric).ok());
        return std::move(*ao);
    }
    /// Every call that says "Context", and those that may be made anywhere.
    void expectRefusals(AmbientOcclusion& ao, StatusCode code) const {
        const std::vector<CubeMapInfo> before = ao.cubeMaps();
        ASSERT_FALSE(before.empty());
        EXPECT_EQ(ao.aoDrawBegin().code(), code);
        EXPECT_EQ(ao.aoDrawEnd(4, 4, 6).code(), code);
        EXPECT_EQ(
            ao.aoApply({.size = {64, 36}, .depth = TextureName{1}}, {4, 4, 6}).status().code(),
            code);
        EXPECT_EQ(ao.addCubeMap({0, 3, 3}).status().code(), code);
        EXPECT_EQ(ao.removeCubeMap(before.front().id).code(), code);
        EXPECT_EQ(ao.clear().code(), code);
        EXPECT_EQ(ao.readVisibility().status().code(), code);
        EXPECT_EQ(ao.readCubeMap(before.front().id).status().code(), code);
        Options other = ao.options();
        other.backbone = Backbone::ScreenSpace;
        EXPECT_EQ(ao.setOptions(other).code(), code);
        EXPECT_EQ(ao.options().backbone, Backbone::Cubemapped) << "what failed changed nothing";
        EXPECT_EQ(ao.lastStatus().code(), code);
        EXPECT_EQ(ao.cubeMaps().size(), before.size());
        (void)ao.statistics();
    }
    /// Names of the current context that a host might have, too.
    std::vector<bool> names(const gl::Functions& of) const {
        std::vector<bool> exist;
        const auto isFramebuffer =
            reinterpret_cast<PFNGLISFRAMEBUFFERPROC>(loader("glIsFramebuffer"));
        const auto isBuffer = reinterpret_cast<PFNGLISBUFFERPROC>(loader("glIsBuffer"));
        const auto isProgram = reinterpret_cast<PFNGLISPROGRAMPROC>(loader("glIsProgram"));
        for (GLuint name = 1; name < 256; ++name) {
            for (const bool is :
                 {of.IsTexture(name) != 0, of.IsVertexArray(name) != 0, of.IsShader(name) != 0,
                  isFramebuffer(name) != 0, isBuffer(name) != 0, isProgram(name) != 0}) {
                exist.push_back(is);
            }
        }
        return exist;
    }
};

TEST_F(ContextsGLTest, ThoseThatShareObjectsAllShowTheSamePicture) {
    Place first(gl, loader);
    const TwinContext second(loader);
    second.makeCurrent();
    Place twin(gl, loader);
    const auto plain = [&] {
        twin.framebuffer.bind();
        return twin.framebuffer.readColour()->pixels;
    };
    second.makeFirstCurrent();
    AmbientOcclusion ao = make();
    const auto alone = first.picture(ao);
    for (int turn = 0; turn < 3; ++turn) {
        second.makeCurrent();
        EXPECT_EQ(twin.picture(ao), alone) << turn;
        if (turn == 1) { // containers made here must reach the first context, too
            EXPECT_TRUE(ao.clear().ok());
            Options finer = ao.options();
            finer.cubeMaps.faceSize = 48;
            EXPECT_TRUE(ao.setOptions(finer).ok());
            (void)twin.picture(ao);
            EXPECT_TRUE(ao.addCubeMap({0, 3, 3}).ok());
            EXPECT_TRUE(ao.readCubeMap(ao.cubeMaps().front().id).ok());
            EXPECT_TRUE(ao.readVisibility().ok());
            EXPECT_TRUE(ao.clear().ok());
            EXPECT_TRUE(ao.setOptions(contextOptions()).ok());
        }
        EXPECT_EQ(plain(), twin.picture(ao));
        second.makeFirstCurrent();
        EXPECT_EQ(first.picture(ao), alone) << turn;
    }
    second.makeCurrent();
    Options other = ao.options();
    other.backbone = Backbone::ScreenSpace;
    EXPECT_TRUE(ao.setOptions(other).ok());
    const auto inSight = twin.picture(ao);
    second.makeFirstCurrent();
    EXPECT_EQ(first.picture(ao), inSight);
    second.makeCurrent();
    { const Place gone = std::move(twin); } // its names belong to the second context
    second.makeFirstCurrent();
}

TEST_F(ContextsGLTest, ComputingGoesOnOverFramesThatAlternate) {
    Options options = contextOptions();
    options.frameBudget = 4.0F;
    options.estimator = Estimator::Automatic;
    options.rayTraced.rays = 16;
    Place first(gl, loader);
    const TwinContext second(loader);
    second.makeCurrent();
    std::optional<Place> twin(std::in_place, gl, loader);
    second.makeFirstCurrent();
    AmbientOcclusion ao = make(options);
    ao.setTexelTracer(std::move(*createTexelTracer(1)));
    for (int frame = 0; frame < 400 && !(frame > 8 && ao.statistics().converged); frame += 2) {
        (void)first.picture(ao);
        second.makeCurrent();
        (void)twin->picture(ao);
        second.makeFirstCurrent();
    }
    EXPECT_TRUE(ao.statistics().converged);
    const auto picture = first.picture(ao);
    second.makeCurrent();
    EXPECT_EQ(twin->picture(ao), picture);
    twin.reset();
    ao.setTexelTracer({});
    second.makeFirstCurrent();
}

TEST_F(ContextsGLTest, AnInstanceMovesToAnotherThread) {
    Place first(gl, loader);
    const TwinContext second(loader);
    AmbientOcclusion ao = make();
    const auto alone = first.picture(ao);
    std::vector<std::uint8_t> elsewhere;
    gl.Finish();
    std::thread thread([&] {
        second.makeCurrent();
        {
            Place twin(gl, loader);
            elsewhere = twin.picture(ao);
        }
        second.makeNoneCurrent();
    });
    thread.join();
    EXPECT_EQ(elsewhere, alone);
    EXPECT_EQ(first.picture(ao), alone);
}

TEST_F(ContextsGLTest, OneThatWasDestroyedTakesOnlyItsOwnObjectsAlong) {
    TwinContext second(loader);
    second.makeCurrent();
    AmbientOcclusion ao = make();
    std::vector<std::uint8_t> alone;
    {
        Place twin(gl, loader);
        alone = twin.picture(ao);
    }
    second.makeFirstCurrent();
    second.destroy();
    Place first(gl, loader);
    EXPECT_EQ(first.picture(ao), alone);
    TwinContext third(loader); // has names that the second had
    third.makeCurrent();
    {
        Place other(gl, loader);
        EXPECT_EQ(other.picture(ao), alone);
    }
    third.makeFirstCurrent();
    EXPECT_TRUE(ao.clear().ok());
    EXPECT_EQ(first.picture(ao), alone);
}

TEST_F(ContextsGLTest, ThoseThatShareNothingAreRefusedAndNotTouched) {
    Place first(gl, loader);
    const TwinContext second(loader, Shares::Nothing);
    AmbientOcclusion ao = make();
    const auto alone = first.picture(ao);
    second.makeCurrent();
    {
        Place stranger(gl, loader);
        AmbientOcclusion own = make(); // names as the other has them
        const auto picture = stranger.picture(own);
        const std::vector<bool> before = names(gl);
        const auto error = reinterpret_cast<PFNGLGETERRORPROC>(loader("glGetError"));
        expectRefusals(ao, StatusCode::WrongContext);
        ao.setTexelTracer({});
        Options other = ao.options();
        other.estimator = Estimator::LayeredIntervals;
        EXPECT_TRUE(ao.setOptions(other).ok()) << "needs no context";
        EXPECT_TRUE(ao.setOptions(contextOptions()).ok());
        EXPECT_EQ(error(), static_cast<GLenum>(GL_NO_ERROR));
        EXPECT_EQ(names(gl), before);
        EXPECT_EQ(stranger.picture(own), picture);
        AmbientOcclusion replaced = std::move(ao);
        replaced = make(); // the former content ends here, in the wrong context
        EXPECT_EQ(error(), static_cast<GLenum>(GL_NO_ERROR));
        EXPECT_EQ(stranger.picture(own), picture);
        EXPECT_EQ(stranger.picture(replaced), picture);
        ao = std::move(replaced);
    }
    second.makeFirstCurrent();
    EXPECT_EQ(ao.aoDrawBegin().code(), StatusCode::WrongContext);
    ao = make();
    EXPECT_EQ(first.picture(ao), alone);
}

TEST_F(ContextsGLTest, WithoutOneCallsAreRefused) {
    Place first(gl, loader);
    const TwinContext second(loader);
    AmbientOcclusion ao = make();
    const auto alone = first.picture(ao);
    second.makeNoneCurrent();
    expectRefusals(ao, StatusCode::NoContext);
    AmbientOcclusion moved = std::move(ao);
    second.makeFirstCurrent();
    EXPECT_EQ(first.picture(moved), alone) << "nothing has changed";
    second.makeNoneCurrent();
    { const AmbientOcclusion gone = std::move(moved); }
    second.makeFirstCurrent();
}

TEST_F(ContextsGLTest, WhatWasAbandonedMakesNoCallOfGl) {
    Place first(gl, loader);
    bool silent = false;
    int calls = 0;
    static bool* quiet = nullptr;
    static int* heard = nullptr;
    static decltype(gl.GetString) getString = nullptr;
    static decltype(gl.DeleteTextures) deleteTextures = nullptr;
    quiet = &silent;
    heard = &calls;
    getString = gl.GetString;
    deleteTextures = gl.DeleteTextures;
    const GLubyte*(APIENTRY * watchedString)(GLenum) = [](GLenum name) {
        *heard += *quiet ? 1 : 0;
        return getString(name);
    };
    void(APIENTRY * watchedDelete)(GLsizei, const GLuint*) = [](GLsizei n, const GLuint* names) {
        *heard += *quiet ? 1 : 0;
        deleteTextures(n, names);
    };
    const auto watched = [&](const char* name) {
        return std::string_view(name) == "glGetString" ? reinterpret_cast<void*>(watchedString)
               : std::string_view(name) == "glDeleteTextures"
                   ? reinterpret_cast<void*>(watchedDelete)
                   : loader(name);
    };
    {
        auto ao = AmbientOcclusion::create(watched, contextOptions());
        ASSERT_TRUE(ao.ok());
        ASSERT_TRUE(host::describeScene(*ao, boxOnFloor(), host::SceneNormals::Geometric).ok());
        (void)first.picture(*ao);
        silent = true;
        ao->abandon();
        expectRefusals(*ao, StatusCode::NoContext);
        ao->setTexelTracer({});
        EXPECT_TRUE(ao->setOptions(contextOptions()).ok());
        EXPECT_TRUE(host::describeScene(*ao, boxOnFloor(), host::SceneNormals::Geometric).ok());
    }
    EXPECT_EQ(calls, 0);
}

TEST_F(ContextsGLTest, ALostOneLeavesTheNewOneAlone) {
    auto second = std::make_unique<TwinContext>(loader, Shares::Nothing);
    second->makeCurrent();
    auto ao = std::make_unique<AmbientOcclusion>(make());
    {
        Place twin(gl, loader);
        (void)twin.picture(*ao);
    }
    second->makeFirstCurrent();
    second.reset();
    Place first(gl, loader);
    AmbientOcclusion own = make();
    const auto picture = first.picture(own);
    const std::vector<bool> before = names(gl);
    ao.reset(); // nobody has told it
    EXPECT_EQ(names(gl), before);
    EXPECT_EQ(first.picture(own), picture);
}

} // namespace
} // namespace aolib
