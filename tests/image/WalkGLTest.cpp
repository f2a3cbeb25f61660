#include <algorithm>
#include <cmath>
#include <vector>

#include "CoreContexts.h"
#include "RenderedScene.h"
#include "content/generated/GeneratedScenes.h"

namespace aolib::test {

namespace {

class WalkGLTest : public GLTest {};

/// World units between two frames: a brisk walk (1.8 units a second) seen three times a second.
constexpr float kStride = 0.6F;
/// Frames until the count of a frame must have come back.
constexpr std::uint64_t kDelay = 4;

/// The walk's corners, and points between them a stride apart.
std::vector<glm::vec3> strides(const std::vector<glm::vec3>& corners) {
    std::vector<glm::vec3> points;
    for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
        const float length = glm::distance(corners[i], corners[i + 1]);
        const int count = std::max(1, static_cast<int>(std::ceil(length / kStride)));
        for (int step = 0; step < count; ++step) {
            points.push_back(glm::mix(corners[i], corners[i + 1],
                                      static_cast<float>(step) / static_cast<float>(count)));
        }
    }
    return points;
}

TEST_P(WalkGLTest, CoverageNeverStaysBelowTheThreshold) {
    const Model model = buildTown();
    Options options;
    options.estimator = Estimator::HorizonSplit;
    options.frameBudget = 0.0F;
    options.cubeMaps.faceSize = 64;
    options.horizonSplit = {.directions = 2, .steps = 2};
    options.blur.enabled = false;
    RenderedScene scene(gl, loader, model, options, 160, 90);
    ASSERT_TRUE(scene.ready());
    const std::vector<glm::vec3> points = strides(townWalk());
    ASSERT_GT(points.size(), 100U);
    int low = 0;
    int counted = 0;
    std::uint64_t last = 0;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        NamedCamera camera;
        camera.eye = points[i];
        camera.target = points[i + 1];
        camera.fovyDeg = 60.0F;
        const AoStatus status = scene.frame(camera);
        ASSERT_TRUE(status.ok()) << status.message();
        const Statistics statistics = scene.ao().statistics();
        ASSERT_LE(statistics.frame - statistics.coverageFrame, kDelay) << "frame " << i;
        if (statistics.coverage < 0.0F || statistics.coverageFrame == last) {
            continue;
        }
        last = statistics.coverageFrame;
        ++counted;
        low = statistics.coverage < options.cubeMaps.coverage ? low + 1 : 0;
        EXPECT_LE(low, 1) << "frame " << i;
    }
    EXPECT_GT(counted, 100);
    EXPECT_GT(scene.ao().cubeMaps().size(), 3U) << "streets with corners need several";
}

AOLIB_FOR_CORE_CONTEXTS(WalkGLTest);

} // namespace

} // namespace aolib::test
