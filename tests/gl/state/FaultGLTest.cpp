// Whatever GL refuses ends in a clean status: the host's state intact, nothing left behind, and the
// instance as good as before once GL gives again.
#include <algorithm>
#include <functional>
#include <map>

#include <glm/gtc/matrix_transform.hpp>

#include "FaultyLoader.h"
#include "Guest.h"
#include "HostTest.h"
#include "host/HostRenderer.h"
#include "host/ModelScene.h"

namespace aolib {
namespace {

/// What a call may answer when GL refuses this.
bool isSensible(Fault fault, StatusCode code) {
    switch (fault) {
    case Fault::CompileShader:
    case Fault::LinkProgram:
        return code == StatusCode::ShaderError;
    case Fault::FramebufferStatus:
        return code == StatusCode::MissingCapability || code == StatusCode::InvalidFramebuffer;
    case Fault::FenceSync:
    case Fault::MapBuffer:
        return false; // coverage is unknown for longer, that is all
    default:
        return code == StatusCode::OutOfMemory;
    }
}

/// Faults that a call may get over without telling: the sight test then says "seen".
bool mayPass(Fault fault) {
    switch (fault) {
    case Fault::GenTextures:
    case Fault::GenFramebuffers:
    case Fault::GenQueries:
    case Fault::FramebufferStatus:
    case Fault::TextureStorage:
    case Fault::TextureSize:
    case Fault::FenceSync:
    case Fault::MapBuffer:
        return true;
    default:
        return false;
    }
}

class FaultGLTest : public HostTest {
protected:
    struct Step {
        const char* name;
        std::function<Status(AmbientOcclusion&)> call;
    };
    using CubeMaps = std::map<CubeMapId, std::vector<float>>;
    /// What an instance holds at the end of its steps.
    struct Outcome {
        std::vector<float> visibility;
        std::vector<std::vector<float>> cubeMaps;
        bool operator==(const Outcome&) const = default;
    };

    void SetUp() override {
        HostTest::SetUp();
        if (IsSkipped() || HasFatalFailure()) {
            return;
        }
        faulty_.emplace(loader);
        depth_ = texture(GL_DEPTH24_STENCIL8, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8);
        normal_ = texture(GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE);
        auto renderer = host::HostRenderer::create(gl, guestScene());
        ASSERT_TRUE(renderer.ok());
        poison->calm();
        renderer->draw(Guest::view(), Guest::projection());
        poison->calm();
    }

    Options options() const {
        Options small = smallOptions();
        small.estimator = estimator_;
        small.cubeMaps.coverage = 0.0F; // placed in an empty scene only: no matter of timing
        return small;
    }
    Result<AmbientOcclusion> make() {
        auto ao = AmbientOcclusion::create(faulty_->loader(), options());
        if (ao) {
            meshes_ = *host::describeScene(*ao, guestScene(), host::SceneNormals::Geometric);
            EXPECT_TRUE(ao->aoSetCamera(Guest::view(), Guest::projection()).ok());
        }
        return ao;
    }
    static Status frame(AmbientOcclusion& ao) {
        (void)ao.aoDrawBegin();
        return ao.aoDrawEnd(Guest::eye().x, Guest::eye().y, Guest::eye().z);
    }
    void viewport(int width, int height) const {
        const GLfloat box[] = {0.0F, 0.0F, static_cast<GLfloat>(width),
                               static_cast<GLfloat>(height)};
        host->has.viewportArray ? host->ViewportIndexedfv(0, box)
                                : host->Viewport(0, 0, width, height);
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
                {"frame of other size",
                 [this](AmbientOcclusion& ao) {
                     viewport(20, 12);
                     const Status status = frame(ao);
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

    /// Where every run starts: nothing placed, the scene to be uploaded anew.
    void reset(AmbientOcclusion& ao) {
        replaced_ = false;
        EXPECT_TRUE(ao.setOptions(options()).ok());
        EXPECT_TRUE(ao.setSceneRenderer({}, {}, {}).ok());
        EXPECT_TRUE(ao.clear().ok());
        const Model scene = guestScene();
        for (std::size_t i = 0; i < meshes_.size(); ++i) {
            const ModelMesh& mesh = scene.meshes[i];
            EXPECT_TRUE(ao.replaceMesh(meshes_[i], {mesh.positions, {}, mesh.indices}).ok());
        }
    }
    static CubeMaps cubeMaps(AmbientOcclusion& ao) {
        CubeMaps all;
        for (const CubeMapInfo& info : ao.cubeMaps()) {
            const CubeMapImage image = *ao.readCubeMap(info.id);
            all[info.id] = image.visibility;
            all[info.id].insert(all[info.id].end(), image.distance.begin(), image.distance.end());
        }
        return all;
    }
    static bool knowsNothing(const std::vector<float>& content) {
        const auto distances = content.begin() + static_cast<std::ptrdiff_t>(content.size() / 2);
        return std::all_of(distances, content.end(), [](float distance) { return distance < 0; });
    }
    /// Runs the steps with the n-th call of a kind refused, each failed step again.
    /// @return what the instance then holds; nothing when there is no n-th call.
    std::optional<Outcome> run(const std::vector<Step>& steps, AmbientOcclusion& ao, Fault fault,
                               int n) {
        Dice dice(static_cast<unsigned>(n));
        poison->apply(dice, HostView{});
        reset(ao);
        faulty_->failAt(fault, n);
        for (const Step& step : steps) {
            const std::string where =
                std::string(faultName(fault)) + " " + std::to_string(n) + " in " + step.name;
            const CubeMaps cubesBefore = cubeMaps(ao);
            const HostState::Snapshot before = state->snapshot();
            const bool failedBefore = faulty_->failed();
            const Status status = step.call(ao);
            const bool hit = faulty_->failed() && !failedBefore;
            EXPECT_EQ(state->difference(before, state->snapshot()), "") << where;
            if (!status) {
                ++refusals_;
                EXPECT_TRUE(hit) << where << ": " << status.message();
                EXPECT_TRUE(isSensible(fault, status.code()))
                    << where << ": " << statusName(status.code()) << ", " << status.message();
                const CubeMaps cubesFailed = cubeMaps(ao);
                const Status again = step.call(ao);
                EXPECT_TRUE(again.ok()) << where << ", again: " << again.message();
                // Each as it was, as it will be, or (after a change of face size) empty; none half
                // done.
                const CubeMaps cubesAfter = cubeMaps(ao);
                for (const auto& [id, content] : cubesFailed) {
                    const auto was = cubesBefore.find(id);
                    const auto is = cubesAfter.find(id);
                    EXPECT_TRUE(knowsNothing(content) ||
                                (was != cubesBefore.end() && was->second == content) ||
                                (is != cubesAfter.end() && is->second == content))
                        << where << ": a cube map is neither the old nor the new";
                }
            } else if (hit) {
                EXPECT_TRUE(mayPass(fault)) << where << " went unnoticed";
            }
        }
        const bool reached = faulty_->failed();
        faulty_->heal();
        Outcome outcome;
        if (const Status last = frame(ao); !last) {
            ADD_FAILURE() << faultName(fault) << " " << n << ": " << last.message();
        }
        outcome.visibility = ao.readVisibility()->visibility;
        for (auto& [id, content] : cubeMaps(ao)) {
            outcome.cubeMaps.push_back(std::move(content));
        }
        poison->calm();
        return reached || n == 0 ? std::optional(outcome) : std::nullopt;
    }

    /// Each call of each kind in turn, until there are no more.
    void refuseEach(const std::function<std::vector<Step>()>& steps,
                    std::initializer_list<Fault> faults, int stride) {
        auto ao = make();
        ASSERT_TRUE(ao.ok()) << ao.status().message();
        const Outcome reference = *run(steps(), *ao, Fault::GenTextures, 0);
        for (const Fault fault : faults) {
            refusals_ = 0;
            int n = 1;
            for (;; n += stride) {
                const auto outcome = run(steps(), *ao, fault, n);
                if (!outcome) {
                    break;
                }
                EXPECT_TRUE(*outcome == reference)
                    << faultName(fault) << " " << n << " leaves a mark";
                ASSERT_FALSE(HasFailure());
            }
            EXPECT_GT(n, 1) << faultName(fault) << " was never called";
            if (isSensible(fault, StatusCode::OutOfMemory) ||
                isSensible(fault, StatusCode::ShaderError) ||
                isSensible(fault, StatusCode::MissingCapability)) {
                EXPECT_GT(refusals_, 0) << faultName(fault) << " was never refused";
            }
        }
        ao = Status(StatusCode::Ok, "");
        EXPECT_EQ(faulty_->alive(), "");
    }

    void TearDown() override {
        depth_ = {};
        normal_ = {};
        HostTest::TearDown();
    }
    gl::Texture texture(GLint internal, GLenum format, GLenum type) {
        auto made = gl::generate<gl::Texture>(gl, &gl::Functions::GenTextures);
        gl.BindTexture(GL_TEXTURE_2D, made.name());
        const std::vector<GLuint> half(HostObjects::kWidth * HostObjects::kHeight, 0x7F7F7F7FU);
        gl.TexImage2D(GL_TEXTURE_2D, 0, internal, HostObjects::kWidth, HostObjects::kHeight, 0,
                      format, type, half.data());
        gl.BindTexture(GL_TEXTURE_2D, 0);
        return made;
    }

    std::optional<FaultyLoader> faulty_;
    gl::Texture depth_;
    gl::Texture normal_;
    std::vector<MeshId> meshes_;
    bool replaced_ = false;
    Estimator estimator_ = Estimator::HorizonSplit;
    int refusals_ = 0;
};

TEST_P(FaultGLTest, CreateThatFailsLeavesNothing) {
    for (int kind = 0; kind < kFaults; ++kind) {
        const auto fault = static_cast<Fault>(kind);
        for (int n = 1;; ++n) {
            Dice dice(static_cast<unsigned>(n));
            poison->apply(dice, HostView{});
            const HostState::Snapshot clean = state->snapshot();
            faulty_->failAt(fault, n);
            const Status status = AmbientOcclusion::create(faulty_->loader(), options()).status();
            const std::string where = std::string(faultName(fault)) + " " + std::to_string(n);
            EXPECT_EQ(state->difference(clean, state->snapshot()), "") << where;
            EXPECT_EQ(faulty_->alive(), "") << where;
            if (!faulty_->failed()) {
                EXPECT_TRUE(status.ok()) << where << ": " << status.message();
                break;
            }
            EXPECT_TRUE(isSensible(fault, status.code()))
                << where << ": " << statusName(status.code()) << ", " << status.message();
            ASSERT_FALSE(HasFailure());
        }
        faulty_->heal();
    }
    poison->calm();
}

TEST_P(FaultGLTest, FramesGetOverWhatGlRefuses) {
    refuseEach([this] { return sceneSteps(); },
               {Fault::GenTextures, Fault::GenBuffers, Fault::GenFramebuffers,
                Fault::GenVertexArrays, Fault::GenQueries, Fault::FramebufferStatus,
                Fault::TextureStorage, Fault::TextureSize, Fault::BufferStorage, Fault::FenceSync},
               1);
}

TEST_P(FaultGLTest, LayersGetOverWhatGlRefuses) {
    estimator_ = Estimator::LayeredIntervals;
    refuseEach([this] { return layerSteps(); },
               {Fault::GenTextures, Fault::GenBuffers, Fault::GenFramebuffers,
                Fault::FramebufferStatus, Fault::TextureStorage, Fault::TextureSize,
                Fault::BufferStorage},
               1);
}

TEST_P(FaultGLTest, TexturesOfTheHostGetOverWhatGlRefuses) {
    refuseEach([this] { return textureSteps(); },
               {Fault::GenTextures, Fault::GenFramebuffers, Fault::FramebufferStatus,
                Fault::TextureStorage, Fault::TextureSize},
               1);
}

TEST_P(FaultGLTest, DrawnScenesGetOverWhatGlRefuses) {
    for (const Estimator estimator : {Estimator::HorizonSplit, Estimator::LayeredIntervals}) {
        estimator_ = estimator;
        refuseEach([] { return drawnSteps(); },
                   {Fault::GenTextures, Fault::GenFramebuffers, Fault::FramebufferStatus,
                    Fault::TextureStorage, Fault::TextureSize},
                   1);
    }
}

TEST_P(FaultGLTest, ShadersThatAreBuiltLateMayFail) {
    for (const auto& [steps, last] :
         {std::pair{textureSteps(), std::size_t{3}}, std::pair{drawnSteps(), std::size_t{0}}}) {
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
    refuseEach([] { return backboneSteps(); },
               {Fault::CreateShader, Fault::CreateProgram, Fault::CompileShader, Fault::LinkProgram,
                Fault::GenTextures, Fault::GenBuffers, Fault::GenQueries},
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
