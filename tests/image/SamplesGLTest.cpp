// Hosts with samples: where a pixel shows several surfaces, or a surface and the background, each
// sample is darkened by W of its own surface. Against the truth of each sample.
#include <algorithm>
#include <cmath>

#include "CoreContexts.h"
#include "MeasuredHost.h"

namespace aolib::test {
namespace {

/// Samples of a pixel whose true W differ by more than this, or of which some are background, show
/// several surfaces.
constexpr float kSeveral = 0.15F;
/// How far a pixel may be outside of what its own samples and its neighbours' are in truth, where
/// the estimator is good, and where it is far off in the midst of surfaces, too.
constexpr float kOutOfRange = 0.2F;
constexpr float kFarOutOfRange = 0.45F;

float orBackground(float w) {
    return w < 0.0F ? 1.0F : w;
}

struct Errors {
    double inner = 0.0; ///< RMSE of pixels that show one surface
    double edges = 0.0; ///< RMSE of those that show several
    double read = 0.0;  ///< of those, of what readVisibility() tells
    int edgePixels = 0;
    int outOfRange = 0; ///< of those
};

Errors errorsOf(const MeasuredHost::Samples& samples, float range) {
    Errors errors;
    double innerPixels = 0.0;
    for (int y = 1; y + 1 < kHeight; ++y) {
        for (int x = 1; x + 1 < kWidth; ++x) {
            const auto at = static_cast<std::size_t>(y * kWidth + x);
            float mean = 0.0F;
            float least = 1.0F;
            float most = 0.0F;
            bool drawn = false;
            bool several = false;
            float darkest = 1.0F;
            float brightest = 0.0F;
            for (const FloatImage& one : samples.truth) {
                const float w = one.pixels[at];
                drawn = drawn || w >= 0.0F;
                several = several || (w < 0.0F) != (samples.truth.front().pixels[at] < 0.0F);
                mean += orBackground(w) / static_cast<float>(samples.truth.size());
                least = std::min(least, orBackground(w));
                most = std::max(most, orBackground(w));
                for (int i = 0; i < 9; ++i) {
                    const auto other =
                        static_cast<std::size_t>((y + i / 3 - 1) * kWidth + x + i % 3 - 1);
                    darkest = std::min(darkest, orBackground(one.pixels[other]));
                    brightest = std::max(brightest, orBackground(one.pixels[other]));
                }
            }
            if (!drawn) {
                continue;
            }
            const float shown = samples.shown.pixels[at];
            const double miss = static_cast<double>(shown - mean);
            const double missRead =
                static_cast<double>(orBackground(samples.read.pixels[at]) - mean);
            if (several || most - least > kSeveral) {
                errors.edges += miss * miss;
                errors.read += missRead * missRead;
                errors.outOfRange += shown < darkest - range || shown > brightest + range ? 1 : 0;
                ++errors.edgePixels;
            } else {
                errors.inner += miss * miss;
                innerPixels += 1.0;
            }
        }
    }
    errors.inner = std::sqrt(errors.inner / innerPixels);
    errors.edges = std::sqrt(errors.edges / errors.edgePixels);
    errors.read = std::sqrt(errors.read / errors.edgePixels);
    return errors;
}

Options sampledOptions(Estimator estimator) {
    Options options;
    options.estimator = estimator;
    options.layeredIntervals = {.slices = 8, .steps = 8};
    options.frameBudget = 0.0F;
    options.radius = 1.5F;
    options.cubeMaps.faceSize = 256;
    options.cubeMaps.place = false;
    return options;
}

class SamplesGLTest : public GLTest {
protected:
    /// @param edges  bound on the RMSE of pixels that show several surfaces
    void expectEdges(const std::string& name, const Options& options, const CameraKind& camera,
                     const FramebufferKind& kind, double edges, float range = kOutOfRange) {
        SCOPED_TRACE(name);
        MeasuredHost host(gl, loader, model_, truth_, options);
        const Errors found = errorsOf(host.samples(camera, kind), range);
        RecordProperty(name, std::to_string(found.edges));
        std::cout << "    " << name << ": RMSE of edges " << found.edges << ", as it is read "
                  << found.read << ", elsewhere " << found.inner << ", out of range "
                  << found.outOfRange << '\n';
        EXPECT_GT(found.edgePixels, 200) << "the test would see nothing";
        EXPECT_LT(found.edges, edges);
        EXPECT_LT(found.read, edges);
        EXPECT_EQ(found.outOfRange, 0);
    }

    const Model model_ = boxes();
    TracedKinds truth_{model_};
    const FramebufferKind four_ = framebufferKinds().at("4 samples");
};

TEST_P(SamplesGLTest, EachSampleIsJudgedByItsOwnSurface) {
    const CameraKind plain = cameraKinds().at("perspective");
    expectEdges("traced, at rest", sampledOptions(Estimator::RayTraced), plain, four_, 0.04);
    const Options layered = sampledOptions(Estimator::LayeredIntervals);
    expectEdges("layered, at rest", layered, plain, four_, 0.04);
    Options moving = layered;
    moving.cubeMaps.refineStaticViews = false;
    expectEdges("layered, texels alone", moving, plain, four_, 0.04);
    moving.cubeMaps.halfResolution = true;
    expectEdges("half resolution", moving, plain, four_, 0.05);
    moving.cubeMaps.halfResolution = false;
    moving.cubeMaps.projection = ProjectionMethod::PingPong;
    expectEdges("ping-pong", moving, plain, four_, 0.04);
    expectEdges("horizon split, blurred", sampledOptions(Estimator::HorizonSplit), plain, four_,
                0.16, kFarOutOfRange);
    Options screen = layered;
    screen.backbone = Backbone::ScreenSpace;
    expectEdges("screen space", screen, plain, four_, 0.09, kFarOutOfRange);
}

TEST_P(SamplesGLTest, WhateverTheCameraAndTheFramebuffer) {
    Options options = sampledOptions(Estimator::LayeredIntervals);
    options.cubeMaps.refineStaticViews = false;
    const CameraKind plain = cameraKinds().at("perspective");
    for (const char* name : {"upper left", "reversed, [0,1], infinite far"}) {
        if (gl.capabilities.clipControl) {
            expectEdges(name, options, cameraKinds().at(name), four_, 0.04);
        }
    }
    FramebufferKind kind = four_;
    kind.origin = {17, 9};
    expectEdges("sub-viewport", options, plain, kind, 0.04);
    kind = four_;
    kind.depth = GL_DEPTH_COMPONENT32F;
    expectEdges("floating-point depth", options, plain, kind, 0.04);
    kind = four_;
    kind.samples = 2;
    expectEdges("2 samples", options, plain, kind, 0.04);
}

AOLIB_FOR_CORE_CONTEXTS(SamplesGLTest);

} // namespace
} // namespace aolib::test
