#include "Offscreen.h"

#include <cstdlib>
#include <utility>

#include "Stage.h"

namespace stage {

std::unique_ptr<aolib::GlContext> openContext(aolib::ContextRequest::Profile profile) {
    aolib::ContextRequest request;
    request.profile = profile;
    request.defaultFramebuffer = true;
    request.width = kWidth;
    request.height = kHeight;
    auto context = aolib::createOffscreenContext(request);
    if (!context) {
        std::exit(fail(context.status().message()));
    }
    return std::move(*context);
}

} // namespace stage
