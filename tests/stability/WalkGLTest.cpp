// For docs/accuracy.md: what a walk shows, in which cube maps are placed and computed on the way.
#include <chrono>
#include <cmath>
#include <thread>

#include "Figures.h"
#include "content/SceneSource.h"

namespace aolib {
namespace {

class WalkGLTest : public StabilityTest {
protected:
    static constexpr int kFrames = 600;
    static constexpr int kBetweenLooks =
        30; ///< frames from one that is compared with truth to the next

    /// To the scene's other camera and back.
    static NamedCamera between(const NamedCamera& from, const NamedCamera& to, int frame) {
        const float way = 2.0F * static_cast<float>(frame) / kFrames;
        const float share = way < 1.0F ? way : 2.0F - way;
        NamedCamera at = from;
        at.eye = glm::mix(from.eye, to.eye, share);
        at.target = glm::mix(from.target, to.target, share);
        return at;
    }
    /// Twelve metres ahead, looking round once.
    static NamedCamera ahead(const NamedCamera& from, int frame) {
        const float share = static_cast<float>(frame) / kFrames;
        const glm::vec3 forward = glm::normalize(from.target - from.eye);
        const glm::vec3 side = glm::normalize(glm::cross(forward, from.up));
        NamedCamera at = from;
        at.eye += 12.0F * share * forward;
        at.target = at.eye + forward * std::cos(6.28F * share) + side * std::sin(6.28F * share);
        return at;
    }
    void walk(const std::string& scene, const Model& model, const Options& o,
              const std::string& which) {
        const std::vector<NamedCamera> cameras = camerasFor(scene, model);
        const auto with = host(model, o, 240, 136);
        std::vector<double> errors;
        double covered = 0.0;
        for (int frame = 0; frame < kFrames; ++frame) {
            with->useCamera(scene == "room" ? between(cameras[1], cameras[0], frame)
                                            : ahead(cameras[1], frame));
            const auto drawn = std::chrono::steady_clock::now() + std::chrono::milliseconds(16);
            if (frame % kBetweenLooks == kBetweenLooks - 1) {
                errors.push_back(errorOf(shoot(*with), model, o, 32).rmse);
                covered += static_cast<double>(with->ao().statistics().coverage);
            } else {
                ASSERT_TRUE(with->frame().ok());
                gl.Finish();
                std::this_thread::sleep_until(drawn);
            }
        }
        report(which + ": coverage", covered / static_cast<double>(errors.size()));
        report(which + ": cube maps", static_cast<double>(with->ao().cubeMaps().size()));
        report(which + ": median RMSE", percentile(errors, 0.5));
        report(which + ": worst RMSE", percentile(errors, 1.0));
    }
};

TEST_P(WalkGLTest, DISABLED_ErrorOnTheWay) {
    for (const std::string scene : {"room", "town"}) {
        const auto model = openScene(scene);
        ASSERT_TRUE(model.ok()) << model.error().sentence;
        for (const float coverage : {0.75F, CubeMapOptions{}.coverage, 0.95F}) {
            for (const bool fallback : {false, true}) {
                Options o = options(0.1F * model->bounds().diagonal());
                o.rayTraced.rays = 256;
                o.frameBudget = 4.0F;
                o.cubeMaps.faceSize = 512;
                o.cubeMaps.place = true;
                o.cubeMaps.coverage = coverage;
                o.cubeMaps.screenSpaceFallback = fallback;
                walk(scene, *model, o,
                     scene + ", a cube map below " + std::to_string(coverage) +
                         (fallback ? ", the rest by what is in sight" : ""));
            }
        }
    }
}

AOLIB_FOR_ALL_ESTIMATORS(WalkGLTest);

} // namespace
} // namespace aolib
