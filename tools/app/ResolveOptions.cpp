#include "app/ResolveOptions.h"

namespace aolib::app {

namespace {

/// What the library takes for a radius of 0, as a share of the diagonal.
constexpr double kDefaultRadius = 0.1;
/// The estimators that the tools take where the command line names none: the most accurate ones.
constexpr Estimator kTraced = Estimator::RayTraced;
constexpr Estimator kNotTraceable = Estimator::LayeredIntervals; ///< screen space
/// Milliseconds per frame for them: a tool waits for the result, and only what is seen is computed.
constexpr float kFrameBudget = 50.0F;

} // namespace

Options resolveOptions(const View& view, const OptionFlags& flags) {
    Options options = view.options;
    flags.apply(options, view.diagonal);
    if (options.estimator == Estimator::Automatic) {
        options.estimator = options.backbone == Backbone::Cubemapped ? kTraced : kNotTraceable;
    }
    if (!flags.given("frame-budget")) {
        options.frameBudget = options.estimator == Estimator::RayTraced ? kFrameBudget : 0.0F;
    }
    if (!(options.radius > 0.0F)) {
        options.radius = static_cast<float>(kDefaultRadius * view.diagonal);
    }
    return options;
}

} // namespace aolib::app
