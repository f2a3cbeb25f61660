#include "backbone/screenspace/BackboneScreenSpace.h"

#include <string>

#include "backbone/Estimators.h"
#include "backbone/ShaderLibrary.h"
#include "gl/Label.h"

namespace aolib {

namespace {

struct ScreenSpaceView final : ViewState {
    std::size_t bytes() const override {
        return ViewState::bytes() + (estimated ? estimated.bytes() : 0);
    }

    gl::RenderToTexture2D estimated; ///< before the blur
};

} // namespace

std::unique_ptr<ViewState> BackboneScreenSpace::makeView() {
    return std::make_unique<ScreenSpaceView>();
}

Result<std::unique_ptr<AbstractBackbone>>
BackboneScreenSpace::create(const BackboneContext& context) {
    std::unique_ptr<BackboneScreenSpace> backbone(new BackboneScreenSpace(context));
    if (AoStatus status = backbone->initialise(); !status) {
        return status;
    }
    if (AoStatus status = backbone->chooseEstimator(); !status) {
        return status;
    }
    return std::unique_ptr<AbstractBackbone>(std::move(backbone));
}

AoStatus BackboneScreenSpace::chooseEstimator() {
    const Estimator estimator = context_.options.estimator;
    if (traitsOf(estimator).shader.empty()) {
        return {StatusCode::InvalidOption,
                "estimator: this one works for Backbone::Cubemapped alone"};
    }
    auto shader =
        buildShader(context_.gl, "fullscreen.vert",
                    "screenspace/visibility_" + std::string(traitsOf(estimator).shader) + ".frag");
    if (shader) {
        shader_ = std::move(*shader);
        estimator_ = estimator;
    }
    return shader.status();
}

Result<const gl::RenderToTexture2D*> BackboneScreenSpace::computeVisibility(const Frame& frame) {
    const gl::DebugGroup group(context_.gl, "aolib: screen-space visibility");
    gl::RenderToTexture2D& target = static_cast<ScreenSpaceView&>(view()).estimated;
    if (AoStatus status =
            target.become(context_.gl, {.width = frame.size.x,
                                        .height = frame.size.y,
                                        .targets = {gl::RenderToTexture2D::Format::RG16F},
                                        .label = "aolib/screenspace/visibility"});
        !status) {
        return status;
    }
    if (estimator_ != context_.options.estimator) {
        if (AoStatus status = chooseEstimator(); !status) {
            return status;
        }
    }
    target.begin(0);
    shader_.bind();
    view().geometry.bind(shader_, frame, 0, 1);
    setEstimatorUniforms(shader_, context_.options, radius());
    context_.generated.drawFullscreen();
    return &target;
}

void BackboneScreenSpace::addStatistics(Statistics& statistics, const ViewState* view) {
    statistics.converged = view != nullptr;
    if (view != nullptr) {
        statistics.coverage = 1.0F;
        statistics.coverageFrame = statistics.frame;
        statistics.computed = 1.0F;
    }
}

} // namespace aolib
