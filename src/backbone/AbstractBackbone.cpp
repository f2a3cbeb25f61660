#include "backbone/AbstractBackbone.h"

#include <array>
#include <cmath>
#include <string>

#include "backbone/Estimators.h"
#include "backbone/ShaderLibrary.h"

namespace aolib {

namespace {

/// Change of the scene's size, as a factor, from which a derived radius follows.
constexpr float kRadiusSlack = 1.25F;

AoStatus keepsNoCubeMaps() {
    return {
        StatusCode::InvalidCallOrder,
        "this backbone keeps no cube maps; set Options::backbone to Backbone::Cubemapped first"};
}

} // namespace

AoStatus AbstractBackbone::initialise() {
    auto geometry = GeometryBuffer::create(context_);
    if (!geometry) {
        return geometry.status();
    }
    geometry_ = std::move(*geometry);
    auto blur = Blur::create(context_);
    if (!blur) {
        return blur.status();
    }
    blur_ = std::move(*blur);
    auto composite = Composite::create(context_);
    if (!composite) {
        return composite.status();
    }
    composite_ = std::move(*composite);
    auto timer = gl::GpuTimer::create(context_.gl);
    if (!timer) {
        return timer.status();
    }
    timer_ = std::move(*timer);
    return {};
}

AoStatus AbstractBackbone::drawEnd(Frame& frame) {
    timer_.begin();
    if (AoStatus status = host_.acquire(context_, frame); !status) {
        return status;
    }
    latest_ = frame;
    buffered_ = false;
    if (AoStatus status = prepare(frame); !status) {
        return status;
    }
    if (context_.options.debugView == DebugView::Off && shadesDirectly()) {
        if (AoStatus status = shadeDirectly(frame); !status) {
            return status;
        }
    } else {
        const auto projected = fillBuffers(frame);
        if (!projected) {
            return projected.status();
        }
        if (AoStatus status = composite_.apply(context_, frame, host_,
                                               {geometry_, visibility_, **projected, radius()});
            !status) {
            return status;
        }
    }
    const AoStatus finished = finishFrame(frame);
    timer_.end();
    ++frame_;
    return finished;
}

Result<TextureName> AbstractBackbone::apply(Frame& frame, const HostTextures& textures) {
    AoStatus status = applied_.attach(context_.gl, textures, frame);
    if (status) {
        status = drawEnd(frame);
    }
    applied_.release(context_.gl);
    if (!status) {
        return status;
    }
    return textures.colour == TextureName{} ? applied_.factor() : TextureName{};
}

Result<const gl::RenderToTexture2D*> AbstractBackbone::fillBuffers(const Frame& frame) {
    if (AoStatus status = geometry_.update(context_, frame, host_); !status) {
        return status;
    }
    if (AoStatus status =
            visibility_.become(context_.gl, {.width = frame.size.x,
                                             .height = frame.size.y,
                                             .targets = {gl::RenderToTexture2D::Format::RG32F},
                                             .label = "aolib/frame/visibility"});
        !status) {
        return status;
    }
    const auto projected = computeVisibility(frame);
    if (projected) {
        const BlurOptions& blur = context_.options.blur;
        if (AoStatus status = blur_.apply(context_, frame, geometry_, **projected,
                                          blur.enabled && noisy() ? blur.size : 1, visibility_);
            !status) {
            return status;
        }
        fillIn(frame, **projected, visibility_);
        buffered_ = true;
    }
    return projected;
}

Result<CubeMapId> AbstractBackbone::addCubeMap(const glm::vec3& /*position*/) {
    return keepsNoCubeMaps();
}
AoStatus AbstractBackbone::removeCubeMap(CubeMapId /*id*/) {
    return keepsNoCubeMaps();
}
AoStatus AbstractBackbone::clear() {
    return {};
}
Result<CubeMapImage> AbstractBackbone::readCubeMap(CubeMapId /*id*/) {
    return keepsNoCubeMaps();
}

Result<VisibilityImage> AbstractBackbone::readVisibility() {
    if (!latest_) {
        return AoStatus(StatusCode::InvalidCallOrder,
                        "there is no frame to read yet; end one with aoDrawEnd first");
    }
    if (!buffered_) {
        if (const auto filled = fillBuffers(*latest_); !filled) {
            return filled.status();
        }
    }
    VisibilityImage image{visibility_.width(), visibility_.height(), {}};
    image.visibility.resize(static_cast<std::size_t>(image.width) *
                            static_cast<std::size_t>(image.height));
    const auto shown = shownVisibility(*latest_);
    if (!shown) {
        return shown.status();
    }
    (*shown)->beginRead(0);
    context_.gl.ReadPixels(0, 0, image.width, image.height, GL_RED, GL_FLOAT,
                           image.visibility.data());
    return image;
}

Result<const gl::RenderToTexture2D*> AbstractBackbone::shownVisibility(const Frame& frame) {
    if (host_.samples() == nullptr) {
        return &visibility_;
    }
    constexpr std::array<GLfloat, 4> kBackground{-1.0F, 0.0F, 0.0F, 0.0F};
    AoStatus status = means_.become(context_.gl, {.width = frame.size.x,
                                                  .height = frame.size.y,
                                                  .targets = {gl::RenderToTexture2D::Format::R32F},
                                                  .label = "aolib/frame/means of samples"});
    if (status) {
        means_.begin(0);
        context_.gl.ClearBufferfv(GL_COLOR, 0, kBackground.data());
        status = composite_.writeMeans(context_, frame, host_, visibility_);
    }
    if (!status) {
        return status;
    }
    return &means_;
}

Statistics AbstractBackbone::statistics() {
    Statistics statistics;
    statistics.frame = frame_;
    statistics.frameGpuMs = timer_.milliseconds();
    statistics.bytesFrame = host_.bytes() + geometry_.bytes() + applied_.bytes() + blur_.bytes() +
                            (visibility_ ? visibility_.bytes() : 0) + (means_ ? means_.bytes() : 0);
    addStatistics(statistics);
    return statistics;
}

float AbstractBackbone::radius() {
    if (context_.options.radius > 0.0F) {
        return context_.options.radius;
    }
    const float size = context_.scene.bounds().diagonal();
    const bool follow = derivedFrom_ <= 0.0F || size > derivedFrom_ * kRadiusSlack ||
                        size < derivedFrom_ / kRadiusSlack;
    if (follow) {
        derivedFrom_ = size;
    }
    return derivedFrom_ > 0.0F ? kRadiusShare * derivedFrom_ : 1.0F;
}

} // namespace aolib
