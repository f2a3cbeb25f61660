#include "backbone/refine/RefinedPixels.h"

#include <array>
#include <utility>
#include <vector>

namespace aolib {

AoStatus RefinedPixels::makeRoom(const gl::Functions& gl, const glm::ivec2& size) {
    if (texture_) {
        return {};
    }
    auto created = gl::TextureStack::create(gl, {.width = size.x,
                                                 .height = size.y,
                                                 .layers = 1,
                                                 .format = gl::RenderToTexture2D::Format::RG32F,
                                                 .label = "aolib/refiner/pixels"});
    if (created) {
        texture_ = std::move(*created);
        texture_->bindAsTarget(0);
        const std::array<float, 4> nothing{kNothing.x, kNothing.y, 0.0F, 0.0F};
        gl.ClearBufferfv(GL_COLOR, 0, nothing.data());
    }
    return created.status();
}

void RefinedPixels::drop(const glm::ivec2& low, const glm::ivec2& size) {
    if (texture_ && size.x > 0 && size.y > 0) {
        const std::vector<glm::vec2> nothing(
            static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y), kNothing);
        texture_->upload(0, low, size, nothing.data());
    }
}

void RefinedPixels::drop() {
    texture_.reset();
    count = 0;
}

} // namespace aolib
