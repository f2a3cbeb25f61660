#pragma once

#include <array>
#include <memory>
#include <vector>

#include <glm/vec2.hpp>

#include "gl/Functions.h"
#include "host/HostFramebuffer.h"
#include "platform/GlContext.h"

namespace aolib::fuzz {

/// Sizes of its framebuffers, pixels.
inline constexpr std::array<glm::ivec2, 4> kFuzzSizes{{{24, 14}, {1, 1}, {130, 5}, {7, 31}}};

/// A context with a host's framebuffers in it, made once.
class FuzzStage {
public:
    static const FuzzStage& get();

    const gl::Functions& gl() const { return gl_; }
    ProcAddressLoader loader() const { return context_->loader(); }
    const host::HostFramebuffer& framebuffer(std::size_t i) const { return framebuffers_.at(i); }
    unsigned error() const { return getError_(); }

private:
    FuzzStage();

    std::unique_ptr<GlContext> context_;
    gl::Functions gl_;
    PFNGLGETERRORPROC getError_ = nullptr;
    std::vector<host::HostFramebuffer> framebuffers_;
};

} // namespace aolib::fuzz
