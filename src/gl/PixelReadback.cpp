#include "gl/PixelReadback.h"

#include <utility>

#include "gl/StateGuard.h"

namespace aolib::gl {

PixelReadback::PixelReadback(PixelReadback&& other) noexcept
    : gl_(other.gl_), buffer_(std::move(other.buffer_)),
      started_(std::exchange(other.started_, false)), fence_(std::exchange(other.fence_, nullptr)) {
}

PixelReadback& PixelReadback::operator=(PixelReadback&& other) noexcept {
    std::swap(gl_, other.gl_);
    std::swap(buffer_, other.buffer_);
    std::swap(started_, other.started_);
    std::swap(fence_, other.fence_);
    return *this;
}

PixelReadback::~PixelReadback() {
    cancel();
}

Result<PixelReadback> PixelReadback::create(const Functions& gl, std::size_t bytes,
                                            const std::string& label) {
    usePixels(gl);
    Result<Buffer> buffer =
        Buffer::create(gl, GL_PIXEL_PACK_BUFFER, bytes, nullptr, GL_STREAM_READ, label);
    gl.BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    if (!buffer) {
        return buffer.status();
    }
    PixelReadback readback;
    readback.gl_ = &gl;
    readback.buffer_ = std::move(*buffer);
    return readback;
}

void PixelReadback::start(int width, int height, GLenum format, GLenum type) {
    usePixels(*gl_);
    gl_->BindBuffer(GL_PIXEL_PACK_BUFFER, buffer_.name());
    gl_->ReadPixels(0, 0, width, height, format, type, nullptr);
    gl_->BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    fence_ = gl_->FenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    started_ = true;
}

bool PixelReadback::arrivesWithin(GLuint64 nanoseconds) const {
    return started_ &&
           (fence_ == nullptr || gl_->ClientWaitSync(fence_, GL_SYNC_FLUSH_COMMANDS_BIT,
                                                     nanoseconds) != GL_TIMEOUT_EXPIRED);
}

bool PixelReadback::arrived() const {
    return arrivesWithin(0);
}

bool PixelReadback::finish(const Take& take) {
    constexpr GLuint64 kSecond = 1000000000;
    while (started_ && !arrived() && !arrivesWithin(kSecond)) {
    }
    if (!started_) {
        return false;
    }
    cancel();
    usePixels(*gl_);
    gl_->BindBuffer(GL_PIXEL_PACK_BUFFER, buffer_.name());
    const void* pixels = gl_->MapBufferRange(
        GL_PIXEL_PACK_BUFFER, 0, static_cast<GLsizeiptr>(buffer_.bytes()), GL_MAP_READ_BIT);
    if (pixels != nullptr) {
        take({static_cast<const std::uint8_t*>(pixels), buffer_.bytes()});
        gl_->UnmapBuffer(GL_PIXEL_PACK_BUFFER);
    }
    gl_->BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    return pixels != nullptr;
}

bool PixelReadback::poll(const Take& take) {
    const bool is = arrived();
    if (is) {
        finish(take);
    }
    return is;
}

void PixelReadback::cancel() {
    started_ = false;
    if (fence_ != nullptr) {
        release(*gl_, 0, [deleteSync = gl_->DeleteSync, fence = std::exchange(fence_, nullptr)] {
            deleteSync(fence);
        });
    }
}

} // namespace aolib::gl
