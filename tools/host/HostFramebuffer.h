#pragma once

#include <vector>

#include <aolib/Status.h>

#include "gl/Handle.h"
#include "image/Image.h"

namespace aolib::host {

/// What a host draws into: RGBA8 colour and 24 bit depth with 8 bit stencil, multisampled or not.
/// Context: the one current at create(), for every call.
class HostFramebuffer {
public:
    struct Settings {
        int width = 0;   ///< pixels, at least 1
        int height = 0;  ///< pixels, at least 1
        int samples = 0; ///< per pixel, 0 for none
    };

    /// Leaves the framebuffer bound. @param gl  must outlive it.
    /// Errors: MissingCapability (the size or the samples), OutOfMemory.
    static Result<HostFramebuffer> create(const gl::Functions& gl, const Settings& settings);

    /// Makes it the one drawn to and read from, and covers it with the viewport.
    void bind() const;
    /// The colours, RGB, the bottom row first; waits for the GPU. Changes what is bound.
    Result<ByteImage> readColour() const;

    /// Depths, 0 to 1, the bottom row first, of one without samples; waits for the GPU. Changes
    /// what is bound.
    std::vector<float> readDepth() const;

    const Settings& settings() const { return settings_; }

private:
    using Renderbuffer = gl::Handle<&gl::Functions::DeleteRenderbuffers>;

    AoStatus attach(Renderbuffer& buffer, GLenum format, GLenum attachment) const;

    const gl::Functions* gl_ = nullptr;
    Settings settings_;
    Renderbuffer colour_;
    Renderbuffer depth_;
    gl::Framebuffer framebuffer_;
};

} // namespace aolib::host
