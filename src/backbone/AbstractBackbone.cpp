#include "backbone/AbstractBackbone.h"

#include <array>
#include <cmath>
#include <string>

#include "backbone/Estimators.h"
#include "backbone/ShaderLibrary.h"
#include "gl/StateGuard.h"

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
    auto geometry = GeometryPass::create(context_);
    if (!geometry) {
        return geometry.status();
    }
    geometryPass_ = std::move(*geometry);
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
    beginView(frame);
    return drawView(frame);
}

AoStatus AbstractBackbone::drawView(Frame& frame) {
    timer_.begin();
    ViewState& of = view();
    if (AoStatus status = of.host.acquire(context_, frame); !status) {
        return status;
    }
    of.latest = frame;
    of.buffered = false;
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
        if (AoStatus status = composite_.apply(context_, frame, of.host,
                                               {of.geometry, of.visibility, **projected, radius()});
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
    frame.size = textures.size;
    beginView(frame);
    AppliedTextures& applied = view().applied;
    AoStatus status = applied.attach(context_.gl, textures, frame);
    if (status) {
        status = drawView(frame);
    }
    applied.release(context_.gl);
    if (!status) {
        return status;
    }
    return textures.colour == TextureName{} ? applied.factor() : TextureName{};
}

Result<const gl::RenderToTexture2D*> AbstractBackbone::fillBuffers(const Frame& frame) {
    ViewState& of = view();
    if (AoStatus status = geometryPass_.update(context_, frame, of.host, of.geometry); !status) {
        return status;
    }
    if (AoStatus status =
            of.visibility.become(context_.gl, {.width = frame.size.x,
                                               .height = frame.size.y,
                                               .targets = {gl::RenderToTexture2D::Format::RG32F},
                                               .label = "aolib/frame/visibility"});
        !status) {
        return status;
    }
    const auto projected = computeVisibility(frame);
    if (projected) {
        const BlurOptions& blur = context_.options.blur;
        if (AoStatus status =
                blur_.apply(context_, frame, of.geometry, **projected,
                            blur.enabled && noisy() ? blur.size : 1, of.blurredRows, of.visibility);
            !status) {
            return status;
        }
        fillIn(frame, **projected, of.visibility);
        of.buffered = true;
    }
    return projected;
}

Result<CubeMapId> AbstractBackbone::addCubeMap(const glm::vec3& /*position*/) {
    return keepsNoCubeMaps();
}
AoStatus AbstractBackbone::beginPreparing(std::span<const glm::vec3> /*positions*/) {
    return keepsNoCubeMaps();
}
Result<float> AbstractBackbone::goOnPreparing(double /*milliseconds*/) {
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
    ViewState* of = views_.current();
    if (of != nullptr && !of->latest) { // its first frame failed: another's was the latest
        for (const auto& one : views_.all()) {
            of = one->latest && (!of->latest || one->drawn > of->drawn) ? one.get() : of;
        }
    }
    return readVisibility(of);
}

Result<VisibilityImage> AbstractBackbone::readVisibility(ViewId id) {
    return readVisibility(views_.find(id));
}

Result<VisibilityImage> AbstractBackbone::readVisibility(ViewState* view) {
    if (view == nullptr || !view->latest) {
        return AoStatus(StatusCode::InvalidCallOrder,
                        "there is no frame of this view to read; end one with aoDrawEnd first");
    }
    if (!view->buffered) {
        const ViewTable::Visit visit(views_, *view);
        if (const auto filled = fillBuffers(*view->latest); !filled) {
            return filled.status();
        }
    }
    const gl::RenderToTexture2D& from = view->visibility;
    VisibilityImage image{from.width(), from.height(), {}};
    image.visibility.resize(static_cast<std::size_t>(image.width) *
                            static_cast<std::size_t>(image.height));
    const auto shown = shownVisibility(*view);
    if (!shown) {
        return shown.status();
    }
    (*shown)->beginRead(0);
    gl::usePixels(context_.gl);
    context_.gl.ReadPixels(0, 0, image.width, image.height, GL_RED, GL_FLOAT,
                           image.visibility.data());
    return image;
}

Result<const gl::RenderToTexture2D*> AbstractBackbone::shownVisibility(const ViewState& of) {
    if (of.host.samples() == nullptr) {
        return &of.visibility;
    }
    const Frame& frame = *of.latest;
    constexpr std::array<GLfloat, 4> kBackground{-1.0F, 0.0F, 0.0F, 0.0F};
    AoStatus status = means_.become(context_.gl, {.width = frame.size.x,
                                                  .height = frame.size.y,
                                                  .targets = {gl::RenderToTexture2D::Format::R32F},
                                                  .label = "aolib/frame/means of samples"});
    if (status) {
        means_.begin(0);
        context_.gl.ClearBufferfv(GL_COLOR, 0, kBackground.data());
        status = composite_.writeMeans(context_, frame, of.host, of.visibility);
    }
    if (!status) {
        return status;
    }
    return &means_;
}

Statistics AbstractBackbone::statistics() {
    return statisticsOf(views_.current());
}

Statistics AbstractBackbone::statistics(ViewId id) {
    return statisticsOf(views_.find(id));
}

Statistics AbstractBackbone::statisticsOf(const ViewState* view) {
    Statistics statistics;
    statistics.frame = frame_;
    statistics.frameGpuMs = timer_.milliseconds();
    statistics.views = static_cast<int>(views_.all().size());
    statistics.bytesFrame = means_ ? means_.bytes() : 0;
    statistics.allConverged = !views_.all().empty();
    for (const auto& one : views_.all()) {
        statistics.bytesFrame += one->bytes();
        statistics.allConverged =
            statistics.allConverged && (!views_.isRecent(*one) || one->converged());
    }
    addStatistics(statistics, view);
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
