#pragma once

#include <memory>

#include "backbone/AbstractBackbone.h"

namespace aolib {

/// The estimator on the host's own view, every frame, nothing kept: the comparator and the
/// fallback.
class BackboneScreenSpace final : public AbstractBackbone {
public:
    /// Errors: ShaderError, OutOfMemory.
    static Result<std::unique_ptr<AbstractBackbone>> create(const BackboneContext& context);

    void optionsChanged(const Options& /*before*/) override {}

private:
    using AbstractBackbone::AbstractBackbone;
    AoStatus drawFrame(const FrameContext& context) override;
    AoStatus computeVisibility(const FrameContext& context) override;
    void addStatistics(Statistics& statistics, const ViewState* view) override;
    std::unique_ptr<ViewState> makeView() override;

    AoStatus chooseEstimator();
    /// Writes each pixel's W, not blurred, to the view's target.
    AoStatus estimate(const FrameContext& context);

    gl::GLSLShader shader_;
    Estimator estimator_{}; ///< that `shader_` was built for
};

} // namespace aolib
