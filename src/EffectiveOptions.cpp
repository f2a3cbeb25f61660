#include "EffectiveOptions.h"

#include "FormerNames.h"
#include "backbone/estimators/Estimators.h"

namespace aolib {

namespace {

/// Share of the scene's diagonal that a derived radius has (thesis 4.3.2 derives likewise).
constexpr float kRadiusShare = 0.1F;
/// Factor by which the scene's diagonal must change before a derived radius changes.
constexpr float kRadiusSlack = 1.25F;
/// Radius in an empty scene, world units.
constexpr float kRadiusOfNothing = 1.0F;

} // namespace

void EffectiveOptions::resolve(const Options& options, const Scene& scene, bool tracer) {
    options_ = options;
    applyFormerNames(options_.cubeMaps);
    options_.estimator = chosenEstimator(options, scene, tracer);
    if (options.radius <= 0.0F) {
        options_.radius = derivedRadius(scene);
    }
}

float EffectiveOptions::derivedRadius(const Scene& scene) {
    const float size = scene.bounds().diagonal();
    if (derivedFrom_ <= 0.0F || size > derivedFrom_ * kRadiusSlack ||
        size < derivedFrom_ / kRadiusSlack) {
        derivedFrom_ = size;
    }
    return derivedFrom_ > 0.0F ? kRadiusShare * derivedFrom_ : kRadiusOfNothing;
}

} // namespace aolib
