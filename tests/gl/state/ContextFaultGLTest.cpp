// What GL refuses in another context than the first, and names that are abandoned.
#include "FaultyLoader.h"
#include "Guest.h"
#include "HostTest.h"
#include "RefusalTest.h"
#include "TwinContext.h"
#include "host/ModelScene.h"

namespace aolib {
namespace {

class ContextFaultGLTest : public ContextTest {
protected:
    void SetUp() override { open({ContextRequest::Api::Egl, ContextRequest::Profile::Core}); }
    void TearDown() override {
        (void)takeDriverMessages(); // programs are compiled again for each context
        ContextTest::TearDown();
    }
};

TEST_F(ContextFaultGLTest, AContextThatCannotBeEnteredIsTriedAgain) {
    FaultyLoader faulty(loader);
    auto ao = AmbientOcclusion::create(faulty.loader(), smallOptions());
    ASSERT_TRUE(ao.ok()) << ao.status().message();
    ASSERT_TRUE(host::describeScene(*ao, guestScene(), host::SceneNormals::Geometric).ok());
    const auto cube = ao->addCubeMap({1, 4, 2});
    ASSERT_TRUE(cube.ok());
    const std::vector<float> content = ao->readCubeMap(*cube)->visibility;
    for (const Fault fault : {Fault::GenVertexArrays, Fault::GenBuffers, Fault::GenFramebuffers,
                              Fault::GenQueries, Fault::FramebufferStatus}) {
        int refused = 0;
        for (int n = 1; n < 100; n += n < 4 ? 1 : 7) {
            const TwinContext twin(loader);
            twin.makeCurrent();
            faulty.failAt(fault, n);
            const auto read = ao->readCubeMap(*cube);
            const bool failed = faulty.failed();
            faulty.heal();
            const auto again = ao->readCubeMap(*cube);
            twin.makeFirstCurrent();
            ASSERT_TRUE(again.ok()) << faultName(fault) << " " << n;
            EXPECT_EQ(again->visibility, content);
            EXPECT_EQ(ao->readCubeMap(*cube)->visibility, content);
            if (!failed) {
                EXPECT_TRUE(read.ok()) << faultName(fault) << " " << n;
                break;
            }
            ++refused;
            EXPECT_TRUE(isSensible(fault, read.status().code()))
                << faultName(fault) << " " << n << ": " << read.status().message();
        }
        EXPECT_GT(refused, 0) << faultName(fault);
    }
}

/// A host whose context is lost, as far as it knows.
class AbandonGLTest : public HostTest {};

TEST_P(AbandonGLTest, ChangesNoState) {
    for (unsigned seed = 0; seed < 4; ++seed) {
        auto ao = AmbientOcclusion::create(loader, smallOptions());
        ASSERT_TRUE(ao.ok());
        EXPECT_TRUE(host::describeScene(*ao, guestScene(), host::SceneNormals::Geometric).ok());
        EXPECT_TRUE(ao->addCubeMap({1, 4, 2}).ok());
        Dice dice(seed);
        poison->apply(dice, HostView{});
        const HostState::Snapshot before = state->snapshot();
        ao->abandon();
        EXPECT_EQ(ao->aoDrawBegin().code(), StatusCode::NoContext);
        EXPECT_EQ(ao->addCubeMap({1, 4, 2}).status().code(), StatusCode::NoContext);
        EXPECT_EQ(ao->clear().code(), StatusCode::NoContext);
        ao->abandon();
        ao = AmbientOcclusion::create(loader, smallOptions());
        EXPECT_TRUE(ao.ok()) << "another one in its place";
        EXPECT_EQ(state->difference(before, state->snapshot()), "") << seed;
    }
    poison->calm();
}

AOLIB_FOR_ALL_CONTEXTS(AbandonGLTest);

} // namespace
} // namespace aolib
