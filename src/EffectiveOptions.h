#pragma once

#include <aolib/Options.h>

#include "scene/Scene.h"

namespace aolib {

/// The host's options with a value in place of each choice that it leaves open: the estimator, and
/// a radius of 0.
class EffectiveOptions {
public:
    /// @param tracer  whether the host gave one.
    void resolve(const Options& options, const Scene& scene, bool tracer);
    /// As the latest resolve() left them.
    const Options& get() const { return options_; }

private:
    /// Radius derived from the scene, world units. It is kept until the scene's size has changed by
    /// a quarter, so that a small edit rebuilds only the cube maps that see it.
    float derivedRadius(const Scene& scene);

    Options options_;
    float derivedFrom_ = 0.0F; ///< diagonal of the scene that the radius belongs to, world units
};

} // namespace aolib
