#pragma once

#include <string>

#include "SmallScene.h"

namespace aolib {

/// Errors of one cube map at the eye, noise of the truth taken off: `sqrt(rmse^2 - noise^2)`.
struct TexelsAndPixels {
    double texels = 0.0; ///< of the texels that the view looks at, weighted by the pixels they fill
    double pixels = 0.0; ///< of the picture: after projection and blur
    double coverage = 0.0;
};

/// A view of a generated scene or a model file.
struct AccuracyCase {
    std::string scene;
    std::size_t camera;  ///< index into camerasFor()
    float radiusShare;   ///< radius as a share of the scene's diagonal
    bool ground = false; ///< with a ground plane under the model
};

TexelsAndPixels measure(const gl::Functions& gl, const ProcAddressLoader& loader,
                        const AccuracyCase& view, Options options);

} // namespace aolib
