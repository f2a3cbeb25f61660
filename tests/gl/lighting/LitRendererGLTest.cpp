#include <map>
#include <tuple>

#include "GLTest.h"
#include "SmallScene.h"
#include "bench/environment/EnvironmentRun.h"
#include "content/generated/Environments.h"

namespace aolib::bench {
namespace {

using host::LitMethod;

/// Environment lighting against a traced picture, on a box on a floor.
class LitRendererGLTest : public ContextTest {
protected:
    void SetUp() override {
        open({ContextRequest::Api::Egl, ContextRequest::Profile::Core});
        if (IsSkipped()) {
            return;
        }
        LitSceneOptions options;
        options.edge = 0.012;
        Result<LitScene> scene = bakeLitScene(boxOnFloor(), options);
        ASSERT_TRUE(scene) << scene.status().message();
        NamedCamera camera;
        camera.eye = glm::vec3(-5.0F, 4.0F, 3.0F);
        camera.target = glm::vec3(0.0F, 0.6F, -0.5F);
        plan_.views.push_back({std::move(*scene), camera});
        plan_.width = 96;
        plan_.height = 54;
        plan_.truthRays = 256;
        plan_.openingRays = 256;
        plan_.frames = 1;
    }
    void TearDown() override {
        if (!IsSkipped()) {
            ContextTest::TearDown();
        }
    }

    using Key = std::tuple<std::string, LitMethod, bool>;
    /// RMSE by environment, method, and whether it was drawn.
    std::map<Key, double> errors(const std::vector<std::string>& environments) {
        for (const std::string& name : environments) {
            plan_.environments.push_back({name, findGeneratedEnvironment(name)->build()});
        }
        const auto goOn = [](const std::string&, double) { return true; };
        const auto figures = runEnvironmentPlan(plan_, gl, loader, goOn);
        EXPECT_TRUE(figures) << figures.status().message();
        std::map<Key, double> result;
        for (const EnvironmentRow& row : figures->rows) {
            result[{row.environment, row.method, row.drawn}] = row.rmse;
            EXPECT_LT(row.noise, 0.06) << row.environment;
        }
        return result;
    }

    EnvironmentPlan plan_;
};

TEST_F(LitRendererGLTest, ErrorsAgainstRaysStayBelowTheirBounds) {
    // Measured, then half as much again: the truth has 256 rays a pixel.
    auto rmse = errors({"sunny", "overcast", "window"});
    for (const bool drawn : {false, true}) {
        const double share = drawn ? 1.5 : 1.0; // values of vertices, and a shadow map
        EXPECT_LT((rmse[{"sunny", LitMethod::ConeAndSun, drawn}]), 0.06 * share) << drawn;
        EXPECT_LT((rmse[{"overcast", LitMethod::Cone, drawn}]), 0.06 * share) << drawn;
        EXPECT_LT((rmse[{"window", LitMethod::Cone, drawn}]), 0.30 * share) << drawn;
        EXPECT_LT((rmse[{"window", LitMethod::SectorsAndSun, drawn}]), 0.15 * share) << drawn;
        EXPECT_LT((rmse[{"sunny", LitMethod::SectorsAndSun, drawn}]), 0.06 * share) << drawn;
        EXPECT_LT((rmse[{"overcast", LitMethod::Sectors, drawn}]), 0.06 * share) << drawn;
        EXPECT_LT((1.5 * rmse[{"window", LitMethod::Sectors, drawn}]),
                  (rmse[{"window", LitMethod::Cone, drawn}]))
            << drawn;
        for (const char* environment : {"sunny", "overcast"}) {
            const double best = rmse[{environment, LitMethod::ConeAndSun, drawn}];
            EXPECT_LT(2.0 * best, (rmse[{environment, LitMethod::Irradiance, drawn}]))
                << environment << drawn;
            EXPECT_LT(2.0 * best, (rmse[{environment, LitMethod::Blurred, drawn}]))
                << environment << drawn;
        }
    }
    EXPECT_NEAR((rmse[{"overcast", LitMethod::BlurredByAngles, true}]),
                (rmse[{"overcast", LitMethod::Blurred, true}]), 0.01);
}

TEST_F(LitRendererGLTest, TheSunLightsOneSideAndTheBoxThrowsAShadow) {
    std::vector<host::LitPiece> pieces = plan_.views[0].scene.pieces;
    for (host::LitPiece& piece : pieces) {
        piece.colour = glm::vec3(1.0F);
    }
    Result<host::LitRenderer> renderer = host::LitRenderer::create(gl, pieces, {129, 129});
    ASSERT_TRUE(renderer) << renderer.status().message();
    ASSERT_TRUE(renderer->setEnvironment(loader, findGeneratedEnvironment("sunny")->build()));
    // From straight above; the sun stands towards +x +z.
    NamedCamera camera;
    camera.eye = glm::vec3(0.0F, 8.0F, 0.0F);
    camera.target = glm::vec3(0.0F);
    camera.up = glm::vec3(0.0F, 0.0F, -1.0F);
    const auto floorAt = [&](LitMethod method, float x, float z) {
        renderer->draw(viewMatrix(camera), projectionMatrix(camera, 1.0F), method);
        const host::LitRenderer::Picture picture = renderer->read();
        const glm::vec4 clip =
            projectionMatrix(camera, 1.0F) * viewMatrix(camera) * glm::vec4(x, 0.0F, z, 1.0F);
        const int column = static_cast<int>((0.5F + 0.5F * clip.x / clip.w) * 129.0F);
        const int row = static_cast<int>((0.5F + 0.5F * clip.y / clip.w) * 129.0F);
        return picture.radiance.at(column, row, 1);
    };
    const float lit = floorAt(LitMethod::ConeAndSun, 1.8F, 2.2F);
    const float shadow = floorAt(LitMethod::ConeAndSun, -0.6F, -1.6F);
    EXPECT_GT(lit, 1.0F) << "3.8 sin(40) / pi and the sky";
    EXPECT_LT(shadow, 0.6F) << "the sky alone";
    EXPECT_GT(floorAt(LitMethod::Irradiance, -0.6F, -1.6F), 0.8F) << "which knows no shadow";
}

} // namespace
} // namespace aolib::bench
