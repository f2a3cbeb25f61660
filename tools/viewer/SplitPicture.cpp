#include "viewer/SplitPicture.h"

#include <utility>

namespace aolib::viewer {

namespace {

void copy(const gl::Functions& gl, const host::HostFramebuffer& from, int x0, int x1, int height) {
    from.bind();
    gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    gl.BlitFramebuffer(x0, 0, x1, height, x0, 0, x1, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

} // namespace

AoStatus SplitPicture::resize(const glm::ivec2& pixels) {
    if (left_ && pixels == size_) {
        return {};
    }
    right_.reset();
    left_.reset();
    Result<host::HostFramebuffer> left =
        host::HostFramebuffer::create(*gl_, {pixels.x, pixels.y, /*samples=*/0});
    if (!left) {
        return left.status();
    }
    left_.emplace(std::move(*left));
    size_ = pixels;
    return {};
}

Result<const host::HostFramebuffer*> SplitPicture::right() {
    if (!right_) {
        Result<host::HostFramebuffer> right =
            host::HostFramebuffer::create(*gl_, {size_.x, size_.y, /*samples=*/0});
        if (!right) {
            return right.status();
        }
        right_.emplace(std::move(*right));
    }
    return &*right_;
}

void SplitPicture::present(int column) const {
    gl_->Disable(GL_SCISSOR_TEST);
    if (left_ && column > 0) {
        copy(*gl_, *left_, 0, column, size_.y);
    }
    if (right_ && column < size_.x) {
        copy(*gl_, *right_, column, size_.x, size_.y);
    }
    gl_->BindFramebuffer(GL_FRAMEBUFFER, 0);
}

ByteImage SplitPicture::readWindow(const gl::Functions& gl, const glm::ivec2& pixels) {
    gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
    gl.ReadBuffer(GL_BACK);
    gl.BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
    ByteImage picture(pixels.x, pixels.y, 3);
    gl.ReadPixels(0, 0, pixels.x, pixels.y, GL_RGB, GL_UNSIGNED_BYTE, picture.pixels.data());
    return picture;
}

} // namespace aolib::viewer
