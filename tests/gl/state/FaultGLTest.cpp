// Whatever GL refuses ends in a clean status: the host's state intact, nothing left behind, and the
// instance as good as before once GL gives again.
#include <glm/gtc/matrix_transform.hpp>

#include "FaultTest.h"

namespace aolib {
namespace {

class FaultGLTest : public FaultTest {
protected:
    void viewport(int width, int height) const {
        const GLfloat box[] = {0.0F, 0.0F, static_cast<GLfloat>(width),
                               static_cast<GLfloat>(height)};
        host->has.viewportArray ? host->ViewportIndexedfv(0, box)
                                : host->Viewport(0, 0, width, height);
    }
    /// Of a cube map of its own: where it fails, what was computed stays half done, which is not to
    /// be compared.
    static AoStatus prepare(AmbientOcclusion& ao) {
        const std::size_t before = ao.cubeMaps().size();
        const AoStatus status = ao.prepare({}, std::array{glm::vec3(0.5F, 3, 2)});
        if (ao.cubeMaps().size() > before) {
            (void)ao.removeCubeMap(ao.cubeMaps().back().id);
        }
        return status;
    }
    std::vector<Step> sceneSteps() {
        const MeshId box = meshes_[1];
        return {{"addCubeMap",
                 [](AmbientOcclusion& ao) {
                     return ao.addCubeMap({1, 4, 2}).status();
                 }},
                {"frame", frame},
                {"moveMesh, frame",
                 [box](AmbientOcclusion& ao) {
                     (void)ao.moveMesh(box, glm::translate(glm::mat4(1), {-1, 0, 1}));
                     return frame(ao);
                 }},
                {"frame of another view",
                 [](AmbientOcclusion& ao) {
                     (void)ao.aoDrawBegin();
                     return ao.aoDrawEnd(Guest::eye().x, Guest::eye().y, Guest::eye().z, ViewId{5});
                 }},
                {"removeView, aoShade",
                 [](AmbientOcclusion& ao) {
                     (void)ao.removeView(ViewId{5});
                     return ao.aoShade(Guest::view(), Guest::projection());
                 }},
                {"prepare", prepare},
                {"frame of other size",
                 [this](AmbientOcclusion& ao) {
                     viewport(20, 12);
                     const AoStatus status = frame(ao);
                     viewport(HostObjects::kWidth, HostObjects::kHeight);
                     return status;
                 }},
                {"face size, frame",
                 [](AmbientOcclusion& ao) {
                     Options changed = ao.options();
                     changed.cubeMaps.faceSize = 20;
                     changed.cubeMaps.outlines = true;
                     (void)ao.setOptions(changed);
                     return frame(ao);
                 }},
                {"replaceMesh, frame",
                 [this](AmbientOcclusion& ao) {
                     const ModelMesh other = guestScene().meshes[2];
                     MeshData data{other.positions, {}, other.indices};
                     data.transform = glm::translate(glm::mat4(1), {0, 0.5F, 1});
                     if (!replaced_) { // once: a frame that failed must not forget it
                         (void)ao.replaceMesh(meshes_[2], data);
                         replaced_ = true;
                     }
                     return frame(ao);
                 }},
                {"half resolution, frame",
                 [](AmbientOcclusion& ao) {
                     Options changed = ao.options();
                     changed.cubeMaps.halfResolution = true;
                     (void)ao.setOptions(changed);
                     return frame(ao);
                 }},
                {"readCubeMap",
                 [](AmbientOcclusion& ao) {
                     return ao.readCubeMap(ao.cubeMaps().front().id).status();
                 }},
                {"frame", frame}};
    }
    std::vector<Step> layerSteps() {
        std::vector<Step> all = sceneSteps();
        std::erase_if(all, [](const Step& step) {
            return std::string(step.name) == "moveMesh, frame" ||
                   std::string(step.name) == "frame of other size";
        });
        return all;
    }
    /// A frame for textures of the host's own.
    std::vector<Step> textureSteps() {
        const auto apply = [this](bool normals, int height) {
            return [this, normals, height](AmbientOcclusion& ao) {
                return ao
                    .aoApply({.size = {HostObjects::kWidth, height},
                              .depth = TextureName{depth_.name()},
                              .normal = TextureName{normals ? normal_.name() : 0U}},
                             Guest::eye())
                    .status();
            };
        };
        return {{"addCubeMap",
                 [](AmbientOcclusion& ao) {
                     return ao.addCubeMap({1, 4, 2}).status();
                 }},
                {"aoApply", apply(false, HostObjects::kHeight)},
                {"aoApply, other size", apply(false, 12)},
                {"aoApply, normals", apply(true, 12)}};
    }
    /// A frame for a depth texture with samples, and what is read of it.
    std::vector<Step> sampledSteps() {
        const auto apply = [this](AmbientOcclusion& ao) {
            return ao
                .aoApply({.size = {HostObjects::kWidth, HostObjects::kHeight},
                          .depth = TextureName{samples_.name()}},
                         Guest::eye())
                .status();
        };
        return {{"aoApply, samples", apply}, {"readVisibility", [](AmbientOcclusion& ao) {
                                                  return ao.readVisibility().status();
                                              }}};
    }
    /// Cube maps that the host draws.
    static std::vector<Step> drawnSteps() {
        const auto nothing = [](const FaceView&) {};
        return {{"setSceneRenderer, addCubeMap",
                 [nothing](AmbientOcclusion& ao) {
                     (void)ao.setSceneRenderer(nothing, {-9, 0, -9}, {9, 2, 9});
                     return ao.addCubeMap({1, 4, 2}).status();
                 }},
                {"aoSceneChanged, frame",
                 [](AmbientOcclusion& ao) {
                     (void)ao.aoSceneChanged({-1, 0, -1}, {1, 1, 1});
                     return frame(ao);
                 }},
                {"frame", frame}};
    }
    static std::vector<Step> backboneSteps() {
        const auto exchange = [](Backbone backbone) {
            return [backbone](AmbientOcclusion& ao) {
                Options changed = ao.options();
                changed.backbone = backbone;
                return ao.setOptions(changed);
            };
        };
        return {{"screen space", exchange(Backbone::ScreenSpace)},
                {"cube maps", exchange(Backbone::Cubemapped)}};
    }
};

TEST_P(FaultGLTest, CreateThatFailsLeavesNothing) {
    for (int kind = 0; kind < kFaults; ++kind) {
        refuseEach("create", static_cast<Fault>(kind), [this](const ProcAddressLoader& with) {
            return AmbientOcclusion::create(with, options()).status();
        });
        ASSERT_FALSE(HasFailure());
    }
    poison->calm();
}

TEST_P(FaultGLTest, FramesGetOverWhatGlRefuses) {
    refuseEachIn([this] { return sceneSteps(); },
                 {Fault::GenTextures, Fault::GenBuffers, Fault::GenFramebuffers,
                  Fault::GenVertexArrays, Fault::GenQueries, Fault::FramebufferStatus,
                  Fault::TextureStorage, Fault::TextureSize, Fault::BufferStorage,
                  Fault::FenceSync},
                 1);
}

TEST_P(FaultGLTest, LayersGetOverWhatGlRefuses) {
    estimator_ = Estimator::LayeredIntervals;
    refuseEachIn([this] { return layerSteps(); },
                 {Fault::GenTextures, Fault::GenBuffers, Fault::GenFramebuffers,
                  Fault::FramebufferStatus, Fault::TextureStorage, Fault::TextureSize,
                  Fault::BufferStorage},
                 1);
}

TEST_P(FaultGLTest, RaysGetOverWhatGlRefuses) {
    estimator_ = Estimator::RayTraced;
    const int stride = host->has.compatibility ? 4 : 1; // what rays ask of GL is the same there
    refuseEachIn([this] { return layerSteps(); },
                 {Fault::GenTextures, Fault::GenBuffers, Fault::GenFramebuffers,
                  Fault::FramebufferStatus, Fault::TextureStorage, Fault::TextureSize,
                  Fault::BufferStorage},
                 stride);
}

TEST_P(FaultGLTest, TexturesOfTheHostGetOverWhatGlRefuses) {
    refuseEachIn([this] { return textureSteps(); },
                 {Fault::GenTextures, Fault::GenFramebuffers, Fault::FramebufferStatus,
                  Fault::TextureStorage, Fault::TextureSize},
                 1);
}

TEST_P(FaultGLTest, SamplesOfTheHostGetOverWhatGlRefuses) {
    refuseEachIn([this] { return sampledSteps(); },
                 {Fault::GenTextures, Fault::GenFramebuffers, Fault::FramebufferStatus,
                  Fault::TextureStorage, Fault::TextureSize},
                 1);
}

TEST_P(FaultGLTest, DrawnScenesGetOverWhatGlRefuses) {
    for (const Estimator estimator : {Estimator::HorizonSplit, Estimator::LayeredIntervals}) {
        estimator_ = estimator;
        refuseEachIn([] { return drawnSteps(); },
                     {Fault::GenTextures, Fault::GenFramebuffers, Fault::FramebufferStatus,
                      Fault::TextureStorage, Fault::TextureSize},
                     1);
    }
}

TEST_P(FaultGLTest, ShadersThatAreBuiltLateMayFail) {
    for (const auto& [steps, last] :
         {std::pair{textureSteps(), std::size_t{3}}, std::pair{sampledSteps(), std::size_t{0}},
          std::pair{drawnSteps(), std::size_t{0}}}) {
        for (const Fault fault : {Fault::CompileShader, Fault::LinkProgram}) {
            auto ao = make();
            ASSERT_TRUE(ao.ok());
            for (std::size_t i = 0; i < last; ++i) {
                ASSERT_TRUE(steps[i].call(*ao).ok());
            }
            const HostState::Snapshot before = state->snapshot();
            faulty_->failAt(fault, 1);
            EXPECT_EQ(steps[last].call(*ao).code(), StatusCode::ShaderError) << steps[last].name;
            EXPECT_TRUE(faulty_->failed());
            EXPECT_EQ(state->difference(before, state->snapshot()), "");
            EXPECT_TRUE(steps[last].call(*ao).ok()) << ao->lastStatus().message();
        }
    }
    EXPECT_EQ(faulty_->alive(), "");
}

TEST_P(FaultGLTest, ABackboneThatCannotBeMadeLeavesTheOldOne) {
    refuseEachIn([] { return backboneSteps(); },
                 {Fault::CreateShader, Fault::CreateProgram, Fault::CompileShader,
                  Fault::LinkProgram, Fault::GenTextures, Fault::GenQueries},
                 3);
}

TEST_P(FaultGLTest, AFrameAfterOneThatFailedIsTimedFromItsOwnStart) {
    auto ao = make();
    ASSERT_TRUE(ao.ok()) << ao.status().message();
    ASSERT_TRUE(frame(*ao).ok());
    host->Finish();
    (void)ao->statistics(); // takes the time of that frame
    poison->calm({.target = HostTarget::ColourOnly});
    EXPECT_EQ(frame(*ao).code(), StatusCode::InvalidFramebuffer);
    poison->calm();
    const int before = faulty_->timestamps;
    ASSERT_TRUE(frame(*ao).ok());
    EXPECT_EQ(faulty_->timestamps - before, 2) << "one for its start, one for its end";
}

AOLIB_FOR_ALL_CONTEXTS(FaultGLTest);

} // namespace
} // namespace aolib
