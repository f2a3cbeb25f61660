#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include <aolib/Status.h>

#include "gl/Buffer.h"

namespace aolib::gl {

/// Reads a small picture back without making anyone wait: a pixel buffer and a fence.
class PixelReadback {
public:
    PixelReadback() = default;
    PixelReadback(PixelReadback&& other) noexcept;
    PixelReadback& operator=(PixelReadback&& other) noexcept;
    ~PixelReadback();

    /// @param bytes  size of the picture. Errors: OutOfMemory.
    static Result<PixelReadback> create(const Functions& gl, std::size_t bytes,
                                        const std::string& label);

    bool pending() const { return fence_ != nullptr; }
    /// Starts reading `width` x `height` pixels of the read framebuffer. Not while pending().
    void start(int width, int height, GLenum format, GLenum type);
    /// Once the pixels have arrived, calls `take` with them and is free again.
    /// @return whether they had arrived.
    bool poll(const std::function<void(std::span<const std::uint8_t>)>& take);
    /// Forgets what was started.
    void cancel();

private:
    const Functions* gl_ = nullptr;
    Buffer buffer_;
    GLsync fence_ = nullptr;
};

} // namespace aolib::gl
