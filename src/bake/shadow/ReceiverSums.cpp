#include "bake/shadow/ReceiverSums.h"

#include <cstddef>
#include <limits>
#include <utility>

#include <glm/common.hpp>
#include <glm/gtc/type_ptr.hpp>

namespace aolib::bake {

namespace {

using Format = gl::RenderToTexture2D::Format;

FrameBox computeBox(const BakeFrame& frame,
                    std::span<const std::optional<SurfacePoint>> receivers) {
    glm::dvec3 low(std::numeric_limits<double>::infinity());
    glm::dvec3 high = -low;
    for (const std::optional<SurfacePoint>& receiver : receivers) {
        if (receiver) {
            const glm::dvec3 place(frame.toFrame(receiver->position));
            low = glm::min(low, place);
            high = glm::max(high, place);
        }
    }
    return low.x > high.x ? FrameBox{} : FrameBox{0.5 * (low + high), 0.5 * (high - low)};
}

} // namespace

Result<ReceiverSums> ReceiverSums::create(const gl::Functions& gl, const glm::ivec2& size) {
    ReceiverSums made;
    made.gl_ = &gl;
    made.size_ = size;
    gl::RenderToTexture2D::Settings settings;
    settings.width = size.x;
    settings.height = size.y;
    settings.targets = {Format::RGBA32F};
    settings.label = "aolib/bake/sums";
    auto sums = gl::RenderToTexture2D::create(gl, settings);
    if (!sums) {
        return sums.status();
    }
    auto receivers =
        gl::TextureStack::create(gl, {size.x, size.y, 3, Format::RGBA32F, "aolib/bake/receivers"});
    if (!receivers) {
        return receivers.status();
    }
    auto fullscreen = gl::VertexArray::createEmpty(gl, "aolib/bake/fullscreen");
    if (!fullscreen) {
        return fullscreen.status();
    }
    made.sums_ = std::move(*sums);
    made.receivers_ = std::move(*receivers);
    made.fullscreen_ = std::move(*fullscreen);
    return made;
}

void ReceiverSums::begin(const BakeFrame& frame,
                         std::span<const std::optional<SurfacePoint>> receivers) {
    box_ = computeBox(frame, receivers);
    sums_.bindAsTarget(0);
    const glm::vec4 nothing(0.0F);
    gl_->ClearBufferfv(GL_COLOR, 0, glm::value_ptr(nothing));
    std::vector<glm::vec4> layer(receivers.size());
    for (int number = 0; number < 3; ++number) {
        for (std::size_t i = 0; i < receivers.size(); ++i) {
            layer[i] = glm::vec4(0.0F);
            if (!receivers[i]) {
                continue;
            }
            const SurfacePoint& point = *receivers[i];
            layer[i] = number == 0   ? glm::vec4(frame.toFrame(point.position), 1.0F)
                       : number == 1 ? glm::vec4(glm::vec3(point.normal), 0.0F)
                                     : glm::vec4(glm::vec3(point.plane), 0.0F);
        }
        receivers_.upload(number, {0, 0}, size_, layer.data());
    }
}

void ReceiverSums::add(gl::GLSLShader& shader) const {
    sums_.bindAsTarget(0);
    receivers_.bind(0);
    shader.set("uReceivers", 0);
    gl_->Enablei(GL_BLEND, 0);
    gl_->BlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
    fullscreen_.drawFullscreen();
    gl_->Disablei(GL_BLEND, 0);
}

std::vector<glm::vec4> ReceiverSums::sums() const {
    std::vector<glm::vec4> texels(static_cast<std::size_t>(size_.x) *
                                  static_cast<std::size_t>(size_.y));
    sums_.bindForReading(0);
    gl_->ReadPixels(0, 0, size_.x, size_.y, GL_RGBA, GL_FLOAT, texels.data());
    return texels;
}

} // namespace aolib::bake
