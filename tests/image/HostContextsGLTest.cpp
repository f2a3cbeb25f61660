// Framebuffer 0, and several contexts, each with an instance of its own.
#include <array>

#include "CoreContexts.h"
#include "MeasuredHost.h"
#include "TwinContext.h"

namespace aolib::test {
namespace {

/// Issue "the best guest": how far the error may be from that of a plain framebuffer.
constexpr double kMostApart = 0.005;

const CameraKind& plainCamera() {
    static const CameraKind camera = cameraKinds().at("perspective");
    return camera;
}

/// A test in a context whose framebuffer 0 can be drawn to.
class WindowGLTest : public ContextTest, public testing::WithParamInterface<TestContext> {
protected:
    void SetUp() override {
        open(GetParam(), {.defaultFramebuffer = true, .width = kWidth, .height = kHeight});
    }
    const Model model_ = boxes();
    TracedKinds truth_{model_};
};

TEST_P(WindowGLTest, FramebufferZeroIsAsGoodAsAnyOther) {
    MeasuredHost host(gl, loader, model_, truth_);
    const double plain = host.error(plainCamera(), {});
    FramebufferKind window;
    window.window = true;
    EXPECT_NEAR(host.error(plainCamera(), window), plain, kMostApart);
    EXPECT_GT(plain, 1e-4) << "the test would see nothing";
    window.resized = true;
    EXPECT_NEAR(host.error(plainCamera(), window), plain, kMostApart);
}

AOLIB_FOR_CORE_CONTEXTS(WindowGLTest);

/// Two hosts, each with its instance in a context of its own, draw by turns and end one after the
/// other.
template <typename UseFirst, typename UseSecond>
void drawByTurns(const std::array<const gl::Functions*, 2>& gl,
                 const std::array<ProcAddressLoader, 2>& loaders, UseFirst useFirst,
                 UseSecond useSecond) {
    const Model model = boxes();
    TracedKinds truth(model);
    std::array<std::optional<MeasuredHost>, 2> hosts;
    useFirst();
    hosts[0].emplace(*gl[0], loaders[0], model, truth);
    const double alone = hosts[0]->error(plainCamera(), {});
    EXPECT_GT(alone, 1e-4) << "the test would see nothing";
    useSecond();
    hosts[1].emplace(*gl[1], loaders[1], model, truth);
    useFirst();
    EXPECT_NEAR(hosts[0]->error(plainCamera(), {}), alone, kMostApart);
    useSecond();
    EXPECT_NEAR(hosts[1]->error(plainCamera(), {}), alone, kMostApart);
    useFirst();
    hosts[0].reset();
    useSecond();
    EXPECT_NEAR(hosts[1]->error(plainCamera(), {}), alone, kMostApart) << "after the other's end";
    hosts[1].reset();
}

class ContextsGLTest : public GLTest {};

TEST_P(ContextsGLTest, EachWithAnInstanceDrawByTurns) {
    const auto second = createContext({.api = GetParam().api, .profile = GetParam().profile});
    ASSERT_TRUE(second.ok()) << second.status().message();
    const auto functions = gl::Functions::load((*second)->loader());
    ASSERT_TRUE(functions.ok());
    drawByTurns(
        {&gl, &*functions}, {loader, (*second)->loader()}, [&] { makeCurrent(); },
        [&] { ASSERT_TRUE((*second)->makeCurrent().ok()); });
    makeCurrent();
}

AOLIB_FOR_CORE_CONTEXTS(ContextsGLTest);

class SharingContextsGLTest : public ContextTest {};

TEST_F(SharingContextsGLTest, EachWithAnInstanceDrawByTurns) {
    open({ContextRequest::Api::Egl, ContextRequest::Profile::Core});
    if (IsSkipped() || HasFatalFailure()) {
        return;
    }
    const TwinContext second(loader);
    drawByTurns(
        {&gl, &gl}, {loader, loader}, [&] { second.makeFirstCurrent(); },
        [&] { second.makeCurrent(); });
}

} // namespace
} // namespace aolib::test
