#pragma once

#include <cstddef>
#include <string>

#include <aolib/Status.h>

#include "gl/Container.h"
#include "gl/Handle.h"
#include "gl/RenderToTexture2D.h"

namespace aolib::gl {

/// A depth texture with several samples per pixel, to which a framebuffer's depth can be copied.
class MultisampleDepth {
public:
    struct Settings {
        int width = 0;  ///< pixels
        int height = 0; ///< pixels
        int samples = 0;
        RenderToTexture2D::Depth format = RenderToTexture2D::Depth::Depth24;
        std::string label;

        bool operator==(const Settings&) const = default;
    };

    /// Makes the texture match the settings, unless it does. May leave its framebuffer bound.
    /// Errors: OutOfMemory, MissingCapability. The texture then stays what it was.
    AoStatus reset(const Functions& gl, const Settings& settings);

    /// Directs rendering and blits to it.
    void beginDraw() const;
    /// Samples that the driver gave: at least as many as were asked for, or fewer where it has no
    /// more.
    int samples() const { return samples_; }
    GLuint textureName() const { return texture_.name(); }
    /// GPU memory of all samples.
    std::size_t bytes() const;

private:
    static Result<MultisampleDepth> create(const Functions& gl, const Settings& settings);
    /// Makes the texture all that a framebuffer has. Errors: MissingCapability.
    static AoStatus attach(const Functions& gl, const Settings& settings, GLuint framebuffer,
                           GLuint texture);

    const Functions* gl_ = nullptr;
    Settings settings_;
    int samples_ = 0;
    Container framebuffer_;
    Texture texture_;
};

/// Binds a multisample texture to a unit for as long as it lives, then binds again what was there:
/// a StateGuard does not save these bindings, because most frames have no samples.
class MultisampleBinding {
public:
    MultisampleBinding(const Functions& gl, GLuint texture, int unit);
    ~MultisampleBinding();
    MultisampleBinding(const MultisampleBinding&) = delete;
    MultisampleBinding& operator=(const MultisampleBinding&) = delete;

private:
    const Functions& gl_;
    GLenum unit_;
    GLint before_ = 0;
};

/// Restricts drawing to single samples for as long as it lives, then puts the host's mask back.
class SampleMask {
public:
    explicit SampleMask(const Functions& gl);
    ~SampleMask();
    SampleMask(const SampleMask&) = delete;
    SampleMask& operator=(const SampleMask&) = delete;

    /// Draws to one sample alone. @param sample  below kMostSamples
    void only(int sample) const;
    /// Bits of a word of the mask.
    static constexpr int kMostSamples = 32;

private:
    const Functions& gl_;
    GLint before_ = 0;
};

} // namespace aolib::gl
