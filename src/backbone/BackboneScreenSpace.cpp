#include "backbone/BackboneScreenSpace.h"

#include <string>

#include "backbone/estimators/Estimators.h"
#include "backbone/frame/ShaderLibrary.h"
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
    auto passes = FramePasses::create(context);
    if (!passes) {
        return passes.status();
    }
    std::unique_ptr<BackboneScreenSpace> backbone(
        new BackboneScreenSpace(context, std::move(*passes)));
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

AoStatus BackboneScreenSpace::drawFrame(const FrameContext& context) {
    if (AoStatus status = computeVisibility(context); !status) {
        return status;
    }
    const auto& of = static_cast<const ScreenSpaceView&>(view());
    return passes_.composite.apply(context, {of.geometry, of.blurred.visibility, of.estimated});
}

AoStatus BackboneScreenSpace::computeVisibility(const FrameContext& context) {
    auto& of = static_cast<ScreenSpaceView&>(view());
    if (AoStatus status = passes_.geometry.update(context, of.geometry); !status) {
        return status;
    }
    if (AoStatus status = estimate(context); !status) {
        return status;
    }
    const BlurOptions& blur = context.options.blur;
    AoStatus status = passes_.blur.apply(context, of.geometry, of.estimated,
                                         blur.enabled ? blur.size : 1, of.blurred);
    of.buffered = status.ok();
    return status;
}

AoStatus BackboneScreenSpace::estimate(const FrameContext& context) {
    const gl::DebugGroup group(context.gl, "aolib: screen-space visibility");
    auto& of = static_cast<ScreenSpaceView&>(view());
    if (AoStatus status =
            of.estimated.reset(context.gl, {.width = context.frame.size.x,
                                            .height = context.frame.size.y,
                                            .targets = {gl::RenderToTexture2D::Format::RG16F},
                                            .label = "aolib/screenspace/visibility"});
        !status) {
        return status;
    }
    if (estimator_ != context.options.estimator) {
        if (AoStatus status = chooseEstimator(); !status) {
            return status;
        }
    }
    of.estimated.bindAsTarget(0);
    shader_.bind();
    of.geometry.bind(shader_, context.frame, 0, 1);
    setEstimatorUniforms(shader_, context.options);
    context.emptyVertexArray.drawFullscreen();
    return {};
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
