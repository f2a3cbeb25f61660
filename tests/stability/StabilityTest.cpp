#include "StabilityTest.h"

#include <cmath>
#include <cstdio>

#include <aolib/RayTracing.h>

namespace aolib {

Options StabilityTest::options(float radius) {
    Options options = atOnce();
    options.estimator = GetParam();
    options.radius = radius;
    options.rayTraced.rays = 64;
    options.cubeMaps.refineStaticViews = false; // what cube maps know, not the view at rest
    options.cubeMaps.faceSize = kFaceSize;
    options.cubeMaps.place = false;
    options.cubeMaps.screenSpaceFallback = false; // what cube maps know
    return options;
}

double StabilityTest::forEach(double horizonSplit, double layeredIntervals, double rayTraced) {
    switch (GetParam()) {
    case Estimator::HorizonSplit:
        return horizonSplit;
    case Estimator::LayeredIntervals:
        return layeredIntervals;
    case Estimator::RayTraced:
        return rayTraced;
    case Estimator::Automatic: // not tested apart
        break;
    }
    return 0.0;
}

std::unique_ptr<SmallHost> StabilityTest::host(const Model& model, const Options& options,
                                               int width, int height) {
    auto host = std::make_unique<SmallHost>(gl, loader, model, options, width, height);
    auto tracer = createTexelTracer();
    EXPECT_TRUE(tracer.ok()) << tracer.status().message();
    host->ao().setTexelTracer(std::move(*tracer));
    return host;
}

Shot StabilityTest::shoot(SmallHost& host) {
    EXPECT_TRUE(host.frame().ok()) << host.ao().lastStatus().message();
    Shot shot{host.visibility(), {}, host.view(), host.projection()};
    expectSound(shot.picture);
    for (const CubeMapInfo& info : host.ao().cubeMaps()) {
        shot.cubes.push_back(*host.ao().readCubeMap(info.id));
        expectSound(shot.cubes.back());
    }
    return shot;
}

Shot StabilityTest::shoot(const Model& model, const Options& options, const NamedCamera& camera,
                          const std::vector<glm::vec3>& cubeMaps, int width, int height) {
    const auto with = host(model, options, width, height);
    with->useCamera(camera);
    for (const glm::vec3& position : cubeMaps) {
        const auto id = with->ao().addCubeMap(position);
        EXPECT_TRUE(id.ok()) << id.status().message();
    }
    return shoot(*with);
}

void expectSound(const VisibilityImage& picture) {
    for (std::size_t i = 0; i < picture.visibility.size(); ++i) {
        const float w = picture.visibility[i];
        ASSERT_TRUE(w == -1.0F || (w >= 0.0F && w <= 1.0F)) << "W of pixel " << i << " is " << w;
    }
}

void expectSound(const CubeMapImage& cube) {
    for (std::size_t i = 0; i < cube.visibility.size(); ++i) {
        const float w = cube.visibility[i];
        ASSERT_TRUE(w >= 0.0F && w <= 1.0F) << "W of texel " << i << " is " << w;
        const float d = cube.distance[i];
        ASSERT_TRUE(d == -1.0F || (std::isfinite(d) && d > 0.0F))
            << "distance of texel " << i << " is " << d;
    }
}

void report(const std::string& what, double figure) {
    const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
    std::printf("%s.%s: %s %.5f\n", test->test_suite_name(), test->name(), what.c_str(), figure);
    std::string key = what;
    for (char& c : key) {
        c = c == ' ' ? '_' : c;
    }
    testing::Test::RecordProperty(key, std::to_string(figure));
}

std::string nameOfEstimator(const testing::TestParamInfo<Estimator>& info) {
    switch (info.param) {
    case Estimator::HorizonSplit:
        return "HorizonSplit";
    case Estimator::LayeredIntervals:
        return "LayeredIntervals";
    case Estimator::RayTraced:
        return "RayTraced";
    case Estimator::Automatic:
        return "Automatic";
    }
    return {};
}

} // namespace aolib
