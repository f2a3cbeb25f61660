// Bakers on the GPU in other contexts than that which they were created in.
#include <functional>

#include "GpuBakerFixture.h"
#include "TwinContext.h"

namespace aolib::bake::test {

namespace {

using Shares = TwinContext::Shares;

class BakeContextsGLTest : public ContextTest {
protected:
    struct Method {
        const char* name;
        std::function<Result<std::unique_ptr<AbstractBaker>>()> create;
    };

    void SetUp() override { open({ContextRequest::Api::Egl, ContextRequest::Profile::Core}); }
    void TearDown() override {
        (void)takeDriverMessages(); // programs are compiled again for each context
        ContextTest::TearDown();
    }
    std::vector<Method> methods() const {
        const auto scene = [] { return sceneOf(unitFloor(1)); };
        return {{"scatter",
                 [this, scene] {
                     return createScatterBaker(loader, scene(),
                                               {.directions = 8, .rasterSize = 64});
                 }},
                {"shadow", [this, scene] {
                     return createShadowBaker(loader, scene(), {.directions = 8, .depthSize = 64});
                 }}};
    }
    static Result<std::vector<BakedMap>> bake(AbstractBaker& baker,
                                              const BakeProgress& progress = {}) {
        MapOptions options;
        options.width = options.height = 8;
        return baker.bakeMaps(options, progress);
    }
};

TEST_F(BakeContextsGLTest, ThoseThatShareObjectsGiveTheSameMaps) {
    const TwinContext twin(loader);
    for (const Method& method : methods()) {
        const auto baker = method.create();
        ASSERT_TRUE(baker.ok()) << baker.status().message();
        const auto first = bake(**baker);
        twin.makeCurrent();
        const auto second = bake(**baker);
        twin.makeFirstCurrent();
        ASSERT_TRUE(first.ok() && second.ok()) << method.name << second.status().message();
        EXPECT_EQ(first->front().visibility, second->front().visibility) << method.name;
    }
}

TEST_F(BakeContextsGLTest, OthersAreRefused) {
    const TwinContext twin(loader, Shares::Nothing);
    for (const Method& method : methods()) {
        auto baker = method.create();
        ASSERT_TRUE(baker.ok());
        twin.makeCurrent();
        EXPECT_EQ(bake(**baker).status().code(), StatusCode::WrongContext) << method.name;
        EXPECT_EQ((*baker)->bakeVertices({.fit = VertexFit::Direct}, {}).status().code(),
                  StatusCode::WrongContext)
            << method.name;
        twin.makeNoneCurrent();
        EXPECT_EQ(bake(**baker).status().code(), StatusCode::NoContext) << method.name;
        twin.makeCurrent();
        *baker = nullptr; // ends where it does not belong
        EXPECT_EQ(takeError(), static_cast<GLenum>(GL_NO_ERROR)) << method.name;
        twin.makeFirstCurrent();
    }
}

TEST_F(BakeContextsGLTest, ACallbackThatLeavesAnotherCurrentEndsTheBake) {
    for (const Shares shares : {Shares::Objects, Shares::Nothing}) {
        const TwinContext twin(loader, shares);
        for (const Method& method : methods()) {
            const auto baker = method.create();
            ASSERT_TRUE(baker.ok());
            const auto leave = [&](double) {
                twin.makeCurrent();
                return true;
            };
            EXPECT_EQ(bake(**baker, leave).status().code(), StatusCode::WrongContext)
                << method.name;
            EXPECT_EQ(takeError(), static_cast<GLenum>(GL_NO_ERROR)) << method.name;
            twin.makeFirstCurrent();
            EXPECT_TRUE(bake(**baker).ok()) << method.name;
        }
    }
}

} // namespace
} // namespace aolib::bake::test
