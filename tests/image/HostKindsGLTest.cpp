// Every camera and framebuffer that a host may have, against truth: the error of what ends up in
// the host's own colours differs little from that of a plain perspective camera.
#include "CoreContexts.h"
#include "MeasuredHost.h"

namespace aolib::test {
namespace {

/// Issue "the best guest": how far the error of a kind may be from the plain one's.
constexpr double kKindsApart = 0.005;

class HostKindsGLTest : public GLTest {
protected:
    void SetUp() override {
        GLTest::SetUp();
        if (!IsSkipped() && !HasFatalFailure()) {
            host_.emplace(gl, loader, model_, truth_);
        }
    }
    void TearDown() override {
        host_.reset();
        GLTest::TearDown();
    }

    static void expectAlike(const std::string& name, const CameraKind& camera,
                            const FramebufferKind& kind, MeasuredHost& host) {
        const double plainError = host.error(cameraKinds().at(camera.like), {});
        const double found = host.error(camera, kind);
        RecordProperty(name, std::to_string(found));
        std::cout << "    " << name << ": RMSE " << found << ", plain " << plainError << '\n';
        EXPECT_LE(std::abs(found - plainError), kKindsApart) << name;
        EXPECT_GT(plainError, 1e-4) << "the test would see nothing";
    }

    const Model model_ = boxes();
    TracedKinds truth_{model_};
    std::optional<MeasuredHost> host_;
};

TEST_P(HostKindsGLTest, CamerasAreAsGoodAsThePlainOne) {
    for (const auto& [name, camera] : cameraKinds()) {
        if ((camera.zeroToOne || camera.upperLeft) && !gl.capabilities.clipControl) {
            std::cout << "    " << name << ": NOT TESTED without clip control\n";
            continue;
        }
        expectAlike(name, camera, {}, *host_);
    }
}

TEST_P(HostKindsGLTest, CamerasAtRestAreAsGoodAsThePlainOne) {
    MeasuredHost atRest(gl, loader, model_, truth_, MeasuredHost::View::AtRest);
    const CameraKind plain = cameraKinds().at("perspective");
    EXPECT_LT(atRest.error(plain, {}), 0.8 * host_->error(plain, {})) << "and better";
    // Those that see the scene another way; an orthographic one keeps its texels.
    for (const char* name :
         {"off-centre", "y flipped", "upper left", "reversed, [0,1], infinite far"}) {
        const CameraKind camera = cameraKinds().at(name);
        if ((!camera.zeroToOne && !camera.upperLeft) || gl.capabilities.clipControl) {
            expectAlike(name, camera, {}, atRest);
        }
    }
    FramebufferKind within;
    within.origin = {13, 7};
    expectAlike("sub-viewport", plain, within, atRest);
}

TEST_P(HostKindsGLTest, FramebuffersAreAsGoodAsThePlainOne) {
    for (const auto& [name, kind] : framebufferKinds()) {
        GLint most = 0;
        gl.GetIntegerv(GL_MAX_SAMPLES, &most);
        if (kind.samples > most) {
            std::cout << "    " << name << ": NOT TESTED, this driver has " << most << '\n';
            continue;
        }
        expectAlike(name, cameraKinds().at("perspective"), kind, *host_);
    }
}

TEST_P(HostKindsGLTest, InstancesDoNotKnowOfEachOther) {
    const CameraKind camera = cameraKinds().at("perspective");
    const double alone = host_->error(camera, {});
    std::optional<MeasuredHost> other;
    other.emplace(gl, loader, model_, truth_);
    EXPECT_EQ(other->error(camera, {}), alone);
    EXPECT_EQ(host_->error(camera, {}), alone);
    other.reset();
    EXPECT_EQ(host_->error(camera, {}), alone) << "after the other's end";
}

AOLIB_FOR_CORE_CONTEXTS(HostKindsGLTest);

} // namespace
} // namespace aolib::test
