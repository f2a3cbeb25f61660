#include "backbone/AbstractBackbone.h"

#include <array>

#include "gl/StateGuard.h"

namespace aolib {

Result<FramePasses> FramePasses::create(const BackboneContext& context) {
    auto geometry = GeometryPass::create(context);
    if (!geometry) {
        return geometry.status();
    }
    auto blur = Blur::create(context);
    if (!blur) {
        return blur.status();
    }
    auto composite = Composite::create(context);
    if (!composite) {
        return composite.status();
    }
    auto timer = gl::GpuTimer::create(context.gl);
    if (!timer) {
        return timer.status();
    }
    return FramePasses{std::move(*geometry), std::move(*blur), std::move(*composite),
                       std::move(*timer)};
}

AoStatus AbstractBackbone::drawEnd(Frame& frame) {
    beginView(frame);
    return drawView(frame);
}

AoStatus AbstractBackbone::drawView(Frame& frame) {
    passes_.timer.begin();
    ViewState& of = view();
    if (AoStatus status = of.host.acquire(context_, frame); !status) {
        return status;
    }
    of.latest = frame;
    of.buffered = false;
    const AoStatus status = drawFrame({context_, frame, of.host});
    passes_.timer.end();
    ++frames_;
    return status;
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
        if (AoStatus status = computeVisibility({context_, *view->latest, view->host}); !status) {
            return status;
        }
    }
    const gl::RenderToTexture2D& from = view->blurred.visibility;
    VisibilityImage image{from.width(), from.height(), {}};
    image.visibility.resize(static_cast<std::size_t>(image.width) *
                            static_cast<std::size_t>(image.height));
    const auto shown = shownVisibility(*view);
    if (!shown) {
        return shown.status();
    }
    (*shown)->bindForReading(0);
    gl::usePixels(context_.gl);
    context_.gl.ReadPixels(0, 0, image.width, image.height, GL_RED, GL_FLOAT,
                           image.visibility.data());
    return image;
}

Result<const gl::RenderToTexture2D*> AbstractBackbone::shownVisibility(const ViewState& of) {
    if (of.host.samples() == nullptr) {
        return &of.blurred.visibility;
    }
    const Frame& frame = *of.latest;
    constexpr std::array<GLfloat, 4> kBackground{-1.0F, 0.0F, 0.0F, 0.0F};
    AoStatus status = means_.reset(context_.gl, {.width = frame.size.x,
                                                 .height = frame.size.y,
                                                 .targets = {gl::RenderToTexture2D::Format::R32F},
                                                 .label = "aolib/frame/means of samples"});
    if (status) {
        means_.bindAsTarget(0);
        context_.gl.ClearBufferfv(GL_COLOR, 0, kBackground.data());
        status = passes_.composite.writeMeans({context_, frame, of.host}, of.blurred.visibility);
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
    statistics.frame = frames_;
    statistics.frameGpuMs = passes_.timer.milliseconds();
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

} // namespace aolib
