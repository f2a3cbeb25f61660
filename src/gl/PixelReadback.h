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

    using Take = std::function<void(std::span<const std::uint8_t>)>;

    std::size_t bytes() const { return buffer_.bytes(); }
    bool pending() const { return started_; }
    /// Starts reading `width` x `height` pixels of the read framebuffer. Not while pending().
    void start(int width, int height, GLenum format, GLenum type);
    /// Whether the pixels have: finish() then does not wait.
    bool arrived() const;
    /// Waits for them, calls `take` with all of the buffer, and is free again.
    /// @return false when there is nothing to take: GL may refuse to show the buffer.
    bool finish(const Take& take);
    /// finish() once they have arrived. @return whether they had.
    bool poll(const Take& take);
    /// Forgets what was started.
    void cancel();

private:
    bool arrivesWithin(GLuint64 nanoseconds) const;

    const Functions* gl_ = nullptr;
    Buffer buffer_;
    bool started_ = false;
    GLsync fence_ = nullptr; ///< null when GL gave none: then mapping the buffer waits
};

} // namespace aolib::gl
