#include "FuzzStage.h"

#include <cstdio>
#include <cstdlib>
#include <utility>

namespace aolib::fuzz {

namespace {

constexpr int kSkip = 77; ///< what ctest takes for "not tested"

} // namespace

const FuzzStage& FuzzStage::get() {
    static const FuzzStage stage;
    return stage;
}

FuzzStage::FuzzStage() {
    auto context = createContext({.api = ContextRequest::Api::OsMesa});
    if (!context) {
        std::fprintf(stderr, "NOT TESTED: %s\n", context.status().message().c_str());
        std::exit(kSkip);
    }
    context_ = std::move(*context);
    gl_ = *gl::Functions::load(loader());
    getError_ = reinterpret_cast<PFNGLGETERRORPROC>(loader()("glGetError"));
    for (const glm::ivec2& size : kFuzzSizes) {
        framebuffers_.push_back(
            std::move(*host::HostFramebuffer::create(gl_, {.width = size.x, .height = size.y})));
    }
}

} // namespace aolib::fuzz
