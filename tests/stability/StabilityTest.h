#pragma once

#include <memory>
#include <string>
#include <vector>

#include "SmallScene.h"

namespace aolib {

/// What one frame shows, and the cube maps behind it.
struct Shot {
    VisibilityImage picture;
    std::vector<CubeMapImage> cubes;
    glm::mat4 view{1.0F};
    glm::mat4 projection{1.0F};
};

/// A test of one estimator, EGL and core.
class StabilityTest : public ContextTest, public testing::WithParamInterface<Estimator> {
protected:
    static constexpr int kWidth = 160;   ///< of pictures, pixels
    static constexpr int kHeight = 90;   ///< of pictures, pixels
    static constexpr int kFaceSize = 64; ///< of cube maps, texels

    void SetUp() override { open({ContextRequest::Api::Egl, ContextRequest::Profile::Core}); }

    /// This estimator's default settings, small faces, cube maps placed by hand.
    static Options options(float radius);
    /// One figure for each estimator.
    static double forEach(double horizonSplit, double layeredIntervals, double rayTraced);

    /// A host whose instance can trace rays.
    std::unique_ptr<SmallHost> host(const Model& model, const Options& options, int width = kWidth,
                                    int height = kHeight);
    /// One sound frame by new cube maps at these positions.
    Shot shoot(const Model& model, const Options& options, const NamedCamera& camera,
               const std::vector<glm::vec3>& cubeMaps, int width = kWidth, int height = kHeight);
    /// A sound frame of a host, and what all its cube maps hold.
    static Shot shoot(SmallHost& host);
};

/// W in [0,1] or -1 for background, in every pixel; a failure names the first that is neither.
void expectSound(const VisibilityImage& picture);
/// W in [0,1] in every texel, its distance finite and above 0, or -1.
void expectSound(const CubeMapImage& cube);

/// Says a figure on standard output, with the test's name, and in its XML report.
void report(const std::string& what, double figure);

/// Instantiates a suite for every estimator.
#define AOLIB_FOR_ALL_ESTIMATORS(suite)                                                            \
    INSTANTIATE_TEST_SUITE_P(All, suite,                                                           \
                             testing::Values(aolib::Estimator::HorizonSplit,                       \
                                             aolib::Estimator::LayeredIntervals,                   \
                                             aolib::Estimator::RayTraced),                         \
                             aolib::nameOfEstimator)

std::string nameOfEstimator(const testing::TestParamInfo<Estimator>& info);

} // namespace aolib
