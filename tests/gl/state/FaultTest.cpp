#include "FaultTest.h"

#include <algorithm>
#include <map>

#include "host/HostRenderer.h"

namespace aolib {

namespace {

using CubeMaps = std::map<CubeMapId, std::vector<float>>;

/// Faults that a call may get overwithout telling: the viewpoint test then says "seen".
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

CubeMaps cubeMaps(AmbientOcclusion& ao) {
    CubeMaps all;
    for (const CubeMapInfo& info : ao.cubeMaps()) {
        const CubeMapImage image = *ao.readCubeMap(info.id);
        all[info.id] = image.visibility;
        all[info.id].insert(all[info.id].end(), image.distance.begin(), image.distance.end());
    }
    return all;
}
bool knowsNothing(const std::vector<float>& content) {
    const auto distances = content.begin() + static_cast<std::ptrdiff_t>(content.size() / 2);
    return std::all_of(distances, content.end(), [](float distance) { return distance < 0; });
}

} // namespace

void FaultTest::SetUp() {
    RefusalTest::SetUp();
    if (IsSkipped() || HasFatalFailure()) {
        return;
    }
    depth_ = texture(GL_DEPTH24_STENCIL8, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8);
    normal_ = texture(GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE);
    samples_ = sampledDepth();
    auto renderer = host::HostRenderer::create(gl, guestScene());
    ASSERT_TRUE(renderer.ok());
    poison->calm();
    renderer->draw(Guest::view(), Guest::projection());
    poison->calm();
}

void FaultTest::TearDown() {
    depth_ = {};
    normal_ = {};
    samples_ = {};
    RefusalTest::TearDown();
}

gl::Texture FaultTest::texture(GLint internal, GLenum format, GLenum type) {
    auto made = gl::generate<gl::Texture>(gl, &gl::Functions::GenTextures);
    gl.BindTexture(GL_TEXTURE_2D, made.name());
    const std::vector<GLuint> half(HostObjects::kWidth * HostObjects::kHeight, 0x7F7F7F7FU);
    gl.TexImage2D(GL_TEXTURE_2D, 0, internal, HostObjects::kWidth, HostObjects::kHeight, 0, format,
                  type, half.data());
    gl.BindTexture(GL_TEXTURE_2D, 0);
    return made;
}

gl::Texture FaultTest::sampledDepth() {
    auto made = gl::generate<gl::Texture>(gl, &gl::Functions::GenTextures);
    gl.BindTexture(GL_TEXTURE_2D_MULTISAMPLE, made.name());
    gl.TexImage2DMultisample(GL_TEXTURE_2D_MULTISAMPLE, 4, GL_DEPTH_COMPONENT24,
                             HostObjects::kWidth, HostObjects::kHeight, GL_TRUE);
    gl.BindTexture(GL_TEXTURE_2D_MULTISAMPLE, 0);
    const auto framebuffer = gl::generate<gl::Framebuffer>(gl, &gl::Functions::GenFramebuffers);
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D_MULTISAMPLE,
                            made.name(), 0);
    constexpr GLfloat kDepth = 0.5F;
    gl.ClearBufferfv(GL_DEPTH, 0, &kDepth);
    gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
    return made;
}

/// Where every run starts: nothing placed, the scene to be uploaded anew.
void FaultTest::reset(AmbientOcclusion& ao) {
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

/// Runs the steps with the n-th call of a kind refused, each failed step again.
/// @return what the instance then holds; nothing when there is no n-th call.
std::optional<FaultTest::Outcome> FaultTest::run(const std::vector<Step>& steps,
                                                 AmbientOcclusion& ao, Fault fault, int n) {
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
        const AoStatus status = step.call(ao);
        const bool hit = faulty_->failed() && !failedBefore;
        EXPECT_EQ(state->difference(before, state->snapshot()), "") << where;
        if (!status) {
            ++refusals_;
            EXPECT_TRUE(hit) << where << ": " << status.message();
            EXPECT_TRUE(isSensible(fault, status.code()))
                << where << ": " << statusName(status.code()) << ", " << status.message();
            const CubeMaps cubesFailed = cubeMaps(ao);
            const AoStatus again = step.call(ao);
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
    if (const AoStatus last = frame(ao); !last) {
        ADD_FAILURE() << faultName(fault) << " " << n << ": " << last.message();
    }
    outcome.visibility = ao.readVisibility()->visibility;
    for (auto& [id, content] : cubeMaps(ao)) {
        outcome.cubeMaps.push_back(std::move(content));
    }
    poison->calm();
    return reached || n == 0 ? std::optional(outcome) : std::nullopt;
}

void FaultTest::refuseEachIn(const std::function<std::vector<Step>()>& steps,
                             std::initializer_list<Fault> faults, int stride) {
    auto ao = make();
    ASSERT_TRUE(ao.ok()) << ao.status().message();
    const Outcome reference = *run(steps(), *ao, Fault::GenTextures, 0);
    const Share part = share();
    for (const Fault fault : faults) {
        refusals_ = 0;
        int n = part.first;
        for (;; n += stride * part.stride) {
            const auto outcome = run(steps(), *ao, fault, n);
            if (!outcome) {
                break;
            }
            EXPECT_TRUE(*outcome == reference) << faultName(fault) << " " << n << " leaves a mark";
            ASSERT_FALSE(HasFailure());
        }
        EXPECT_GT(n, 1) << faultName(fault) << " was never called";
        const bool tells = isSensible(fault, StatusCode::OutOfMemory) ||
                           isSensible(fault, StatusCode::ShaderError) ||
                           isSensible(fault, StatusCode::MissingCapability);
        if (tells && part.stride == 1) {
            EXPECT_GT(refusals_, 0) << faultName(fault) << " was never refused";
        }
    }
    ao = AoStatus(StatusCode::Ok, "");
    EXPECT_EQ(faulty_->alive(), "");
}

} // namespace aolib
