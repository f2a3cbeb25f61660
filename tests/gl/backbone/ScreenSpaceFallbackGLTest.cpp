// What no cube map knows is shaded by what is in viewpoint.
#include "ProgressiveTest.h"
#include "WatchedLoader.h"

namespace aolib {
namespace {

class FallbackGLTest : public ProgressiveTest {
protected:
    static constexpr glm::vec3 kEye{1.0F, 3.0F, -5.0F};
    /// On the floor behind the walls, and on one's back.
    static constexpr std::array<glm::vec3, 2> kHidden{{{0.5F, 0, -1.5F}, {-1.0F, 0.5F, -1.0F}}};

    static Options options() {
        Options o = ProgressiveTest::options(Estimator::RayTraced);
        o.frameBudget = 0.0F;
        o.rayTraced.rays = 64;
        o.cubeMaps.screenSpaceFallback = true;
        o.cubeMaps.refineStaticViews = false;
        return o;
    }
    static Options without() {
        Options o = options();
        o.cubeMaps.screenSpaceFallback = false;
        return o;
    }
    /// Seen from behind, and drawn until a survey has looked.
    SmallHost hostOf(const Options& o, const glm::vec3& cubeMap = {0, 1, 5}) {
        SmallHost host = hostWith(o, walls());
        host.lookAt(kEye, {0, 0.3F, -0.6F});
        EXPECT_TRUE(host.ao().addCubeMap(cubeMap).ok());
        for (int i = 0; i < 6; ++i) {
            EXPECT_TRUE(host.frame().ok());
            gl.Finish();
        }
        return host;
    }
};

TEST_P(FallbackGLTest, ShadesWhatNoCubeMapKnows) {
    SmallHost truth = hostOf(options(), kEye);
    SmallHost white = hostOf(without());
    SmallHost host = hostOf(options());
    EXPECT_LT(host.ao().statistics().coverage, 0.75F) << "nothing is hidden";
    EXPECT_EQ(host.ao().statistics().coverage, white.ao().statistics().coverage);
    for (const glm::vec3& place : kHidden) {
        EXPECT_EQ(white.visibilityAt(place), 1.0F);
        EXPECT_LT(truth.visibilityAt(place), 0.85F) << "this shows nothing";
        EXPECT_NEAR(host.visibilityAt(place), truth.visibilityAt(place), 0.12F);
    }
    const Picture wanted = truth.visibility().visibility;
    EXPECT_LT(rmse(wanted, host.visibility().visibility),
              0.4 * rmse(wanted, white.visibility().visibility));
}

TEST_P(FallbackGLTest, LeavesWhatIsKnownAsItIs) {
    for (const bool half : {false, true}) {
        for (const ProjectionMethod method :
             {ProjectionMethod::SinglePass, ProjectionMethod::PingPong}) {
            const auto picture = [&](Options o) {
                o.cubeMaps.halfResolution = half;
                o.cubeMaps.projection = method;
                return hostOf(o).visibility().visibility;
            };
            const Picture white = picture(without());
            const Picture filled = picture(options());
            std::size_t changed = 0;
            for (std::size_t i = 0; i < white.size(); ++i) {
                EXPECT_TRUE(filled[i] == white[i] || white[i] == 1.0F) << "pixel " << i;
                EXPECT_TRUE(filled[i] == -1.0F || (filled[i] >= 0.0F && filled[i] <= 1.0F));
                changed += filled[i] != white[i] ? 1 : 0;
            }
            EXPECT_GT(changed, white.size() / 20);
        }
    }
}

TEST_P(FallbackGLTest, TheHostsPictureIsDarkenedByWhatIsRead) {
    for (const Estimator estimator : {Estimator::RayTraced, Estimator::HorizonSplit}) {
        for (const bool half : {false, true}) {
            Options o = options();
            o.estimator = estimator;
            o.cubeMaps.halfResolution = half;
            SmallHost host = hostOf(o);
            const ByteImage shown = *host.framebuffer().readColour();
            const Picture w = host.visibility().visibility;
            o.contrast = 0.0F;
            ASSERT_TRUE(host.ao().setOptions(o).ok());
            ASSERT_TRUE(host.frame().ok());
            const ByteImage plain = *host.framebuffer().readColour();
            for (std::size_t i = 0; i < w.size(); ++i) {
                const float factor = w[i] < 0.0F ? 1.0F : w[i];
                ASSERT_NEAR(shown.pixels[3 * i], factor * plain.pixels[3 * i], 1.5F)
                    << "pixel " << i << ", W " << w[i] << (half ? ", half" : "");
            }
        }
    }
}

TEST_P(FallbackGLTest, CostsNothingWhereAllIsKnown) {
    EXPECT_EQ(std::make_unique<SmallHost>(hostOf(options(), kEye))->ao().statistics().bytesFrame,
              std::make_unique<SmallHost>(hostOf(without(), kEye))->ao().statistics().bytesFrame);
}

TEST_P(FallbackGLTest, GivesItsBufferBackOnceAllIsKnown) {
    SmallHost host = hostOf(options());
    const std::size_t filled = host.ao().statistics().bytesFrame;
    host.lookAt({0, 1, 5}, {0, 0.5F, 0}); // from the cube map's own place
    for (int i = 0; i < 12; ++i) {
        ASSERT_TRUE(host.frame().ok());
        gl.Finish();
    }
    EXPECT_EQ(filled - host.ao().statistics().bytesFrame, 160U * 90U * (4U + 2U));
}

TEST_P(FallbackGLTest, WaitsUntilHalfOfAllIsKnownOnASoftwareRasteriser) {
    Options o = options();
    o.frameBudget = 1e-6F;
    SmallHost host = hostWith(o, walls());
    host.lookAt(kEye, {0, 0.3F, -0.6F});
    ASSERT_TRUE(host.ao().addCubeMap({5, 4, 3}).ok());
    bool white = false;
    bool filled = false;
    for (int i = 0; i < kMostFrames && !filled; ++i) {
        ASSERT_TRUE(host.frame().ok());
        gl.Finish();
        const float before = host.ao().statistics().coverage; // that this frame went by
        const float w = host.visibilityAt(kHidden[1]);
        filled = w < 1.0F;
        white = white || !filled;
        EXPECT_EQ(filled, before >= 0.5F) << "frame " << i << ", coverage " << before;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    EXPECT_TRUE(white);
    EXPECT_TRUE(filled);
}

TEST_P(FallbackGLTest, ShadesFromTheFirstFrameOnWhereThereIsAGraphicsCard) {
    Options o = options();
    o.frameBudget = 1e-6F;
    const WatchedLoader watched(loader, "a graphics card");
    SmallHost host = hostWith(o, walls(), watched.loader());
    host.lookAt(kEye, {0, 0.3F, -0.6F});
    ASSERT_TRUE(host.frame().ok()); // no cube map stands yet
    for (const glm::vec3& place : kHidden) {
        EXPECT_LT(host.visibilityAt(place), 0.9F);
    }
    const Picture none = host.visibility().visibility;
    ASSERT_TRUE(host.ao().addCubeMap({0, 1, 5}).ok());
    for (int i = 0; i < 20; ++i) {
        ASSERT_TRUE(host.frame().ok());
        for (const glm::vec3& place : kHidden) {
            EXPECT_LT(host.visibilityAt(place), 0.9F) << "frame " << i;
        }
    }
    o.cubeMaps.screenSpaceFallback = false;
    ASSERT_TRUE(host.ao().clear().ok());
    ASSERT_TRUE(host.ao().setOptions(o).ok());
    ASSERT_TRUE(host.frame().ok());
    const Picture white = host.visibility().visibility;
    EXPECT_GT(rmse(none, white), 0.05);
    EXPECT_EQ(*std::max_element(white.begin(), white.end()), 1.0F);
    EXPECT_TRUE(std::ranges::all_of(white, [](float w) { return w == -1.0F || w == 1.0F; }));
}

AOLIB_FOR_ALL_CONTEXTS(FallbackGLTest);

} // namespace
} // namespace aolib
