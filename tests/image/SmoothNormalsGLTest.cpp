// Meshes of few triangles that look smooth by their normals: what is computed of them is the truth
// about those normals, by rays and by layered intervals, in texels and in pixels of a view at rest.
#include <chrono>
#include <cmath>
#include <numbers>
#include <thread>
#include <utility>

#include <aolib/RayTracing.h>
#include <glm/gtc/matrix_transform.hpp>

#include "CoreContexts.h"
#include "RenderedScene.h"
#include "SmallScene.h"
#include "TracedView.h"

namespace aolib::test {

namespace {

constexpr int kSmoothWidth = 144;
constexpr int kSmoothHeight = 81;
constexpr int kMostSmoothFrames = 4000;
constexpr float kSmoothRadius = 1.5F;

/// A ring of 108 triangles.
ModelMesh ring(const glm::mat4& transform) {
    constexpr int kAround = 9;
    constexpr int kAcross = 6;
    constexpr float kTurn = 2.0F * std::numbers::pi_v<float>;
    ModelMesh mesh;
    mesh.transform = transform;
    for (int i = 0; i < kAround; ++i) {
        const float u = kTurn * static_cast<float>(i) / kAround;
        for (int j = 0; j < kAcross; ++j) {
            const float v = kTurn * static_cast<float>(j) / kAcross;
            const glm::vec3 spoke(std::cos(u), 0.0F, std::sin(u));
            const glm::vec3 normal = std::cos(v) * spoke + glm::vec3(0.0F, std::sin(v), 0.0F);
            mesh.positions.push_back(1.6F * spoke + 0.6F * normal);
            mesh.normals.push_back(normal);
            const auto at = [&](int along, int across) {
                return static_cast<std::uint32_t>((i + along) % kAround * kAcross +
                                                  (j + across) % kAcross);
            };
            for (const std::uint32_t index :
                 {at(0, 0), at(0, 1), at(1, 0), at(1, 0), at(0, 1), at(1, 1)}) {
                mesh.indices.push_back(index);
            }
        }
    }
    return mesh;
}

/// Two such rings, one squashed and mirrored, on a floor that has no normals.
Model rings() {
    Model model;
    addQuad(model, {-8, 0, -8}, {-8, 0, 8}, {8, 0, 8}, {8, 0, -8});
    const glm::mat4 first = glm::translate(glm::mat4(1.0F), glm::vec3(-0.9F, 0.6F, 0.0F));
    const glm::mat4 second = glm::translate(glm::mat4(1.0F), glm::vec3(1.7F, 1.0F, -1.3F));
    model.meshes.push_back(ring(first));
    model.meshes.push_back(ring(glm::scale(glm::rotate(second, 1.0F, glm::vec3(1.0F, 0.3F, 0.0F)),
                                           glm::vec3(-0.6F, 1.3F, 0.8F))));
    return model;
}

NamedCamera smoothCamera() {
    NamedCamera camera;
    camera.eye = {3.4F, 3.0F, 4.2F};
    camera.target = {0.2F, 0.5F, -0.2F};
    return camera;
}

class SmoothNormalsGLTest : public GLTest {
protected:
    /// W of the view at rest.
    FloatImage settled(Estimator estimator, bool repair, bool withTracer) {
        Options options;
        options.estimator = estimator;
        options.radius = kSmoothRadius;
        options.frameBudget = 20.0F;
        options.cubeMaps.faceSize = 128;
        options.cubeMaps.refineStaticViews = repair;
        RenderedScene scene(gl, loader, rings(), options, kSmoothWidth, kSmoothHeight,
                            host::SceneNormals::Model);
        if (withTracer) {
            scene.ao().setTexelTracer(std::move(*createTexelTracer(2)));
        }
        for (int frame = 0; frame < kMostSmoothFrames; ++frame) {
            const AoStatus status = scene.frame(smoothCamera());
            EXPECT_TRUE(status.ok()) << status.message();
            gl.Finish();
            const Statistics statistics = scene.ao().statistics();
            if (!status || (statistics.converged && statistics.cubeMapsProjected > 0)) {
                return scene.visibility();
            }
            std::this_thread::sleep_for(std::chrono::milliseconds(1)); // for the tracer's worker
        }
        ADD_FAILURE() << "the picture never converged";
        return scene.visibility();
    }
};

TEST_P(SmoothNormalsGLTest, TexelsAndPixelsFollowTheTruthAboutThem) {
    const auto truth = [](NormalSource normals) {
        return visibilityOf(traceView(rings(), smoothCamera(), kSmoothWidth, kSmoothHeight,
                                      kSmoothRadius, 1024, normals));
    };
    const FloatImage smooth = truth(NormalSource::Given);
    EXPECT_GT(rmse(truth(NormalSource::Geometric), smooth), 0.05) << "else all would pass";
    struct Way {
        Estimator estimator;
        bool repair;
        bool tracer;
        double bound;
    };
    // The truth's own noise is 0.003. Behind each bound: what was measured, on llvmpipe.
    for (const auto& [estimator, repair, tracer, bound] :
         {Way{Estimator::Automatic, false, true, 0.010},          // 0.0071
          Way{Estimator::Automatic, true, true, 0.007},           // 0.0044
          Way{Estimator::LayeredIntervals, false, false, 0.028},  // 0.0220
          Way{Estimator::LayeredIntervals, true, false, 0.013},   // 0.0094
          Way{Estimator::LayeredIntervals, true, true, 0.010}}) { // 0.0070
        EXPECT_LT(rmse(settled(estimator, repair, tracer), smooth), bound)
            << "estimator " << static_cast<int>(estimator) << ", repair " << repair;
    }
}

AOLIB_FOR_CORE_CONTEXTS(SmoothNormalsGLTest);

} // namespace

} // namespace aolib::test
