#include "backbone/cubemapped/Coverage.h"

#include "backbone/ShaderLibrary.h"
#include "gl/Label.h"

namespace aolib {

Result<Coverage> Coverage::create(const BackboneContext& context) {
    auto shader = buildShader(context.gl, "fullscreen.vert", "frame/coverage.frag");
    if (!shader) {
        return shader.status();
    }
    auto target =
        gl::RenderToTexture2D::create(context.gl, {.width = kSize,
                                                   .height = kSize,
                                                   .targets = {gl::RenderToTexture2D::Format::RG8},
                                                   .label = "aolib/coverage"});
    if (!target) {
        return target.status();
    }
    Coverage coverage;
    coverage.shader_ = std::move(*shader);
    coverage.target_ = std::move(*target);
    for (Request& request : coverage.requests_) {
        auto readback =
            gl::PixelReadback::create(context.gl, 2 * kSize * kSize, "aolib/coverage/readback");
        if (!readback) {
            return readback.status();
        }
        request.readback = std::move(*readback);
    }
    return coverage;
}

void Coverage::count(const BackboneContext& context, const Frame& frame,
                     const GeometryBuffer& geometry, const gl::RenderToTexture2D& visibility,
                     std::uint64_t frameNumber) {
    const gl::DebugGroup group(context.gl, "aolib: coverage");
    for (Request& request : requests_) {
        if (request.readback.pending()) {
            continue;
        }
        target_.begin(0);
        shader_.bind();
        geometry.bindDepth(0);
        visibility.bindTexture(0, 1);
        shader_.set("uLinearDepth", 0);
        shader_.set("uVisibility", 1);
        shader_.set("uViewSize", glm::vec2(frame.size));
        shader_.set("uTargetSize", glm::vec2(kSize));
        context.generated.drawFullscreen();
        target_.beginRead(0);
        request.readback.start(kSize, kSize, GL_RG, GL_UNSIGNED_BYTE);
        request.frame = frameNumber;
        return;
    }
}

std::optional<Coverage::Answer> Coverage::poll() {
    std::optional<Answer> newest;
    for (Request& request : requests_) {
        request.readback.poll([&](std::span<const std::uint8_t> pixels) {
            std::uint64_t geometry = 0;
            std::uint64_t shaded = 0;
            for (std::size_t i = 0; i < pixels.size(); i += 2) {
                geometry += pixels[i];
                shaded += pixels[i + 1];
            }
            if (!newest || request.frame > newest->frame) {
                newest = Answer{request.frame, geometry > 0 ? static_cast<float>(shaded) /
                                                                  static_cast<float>(geometry)
                                                            : 1.0F};
            }
        });
    }
    return newest;
}

void Coverage::restart() {
    for (Request& request : requests_) {
        request.readback.cancel();
    }
}

} // namespace aolib
