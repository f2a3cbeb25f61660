#include "backbone/passes/FeedbackPass.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include <glm/vec4.hpp>

#include "backbone/frame/ShaderLibrary.h"
#include "gl/Label.h"

namespace aolib {

namespace {

/// The number of a point's cube map, which the lowest bits of a footprint hold
/// (shaders/cubemap/feedback.frag).
std::size_t cubeMapOf(float footprint) {
    return std::bit_cast<std::uint32_t>(footprint) & 63U;
}

} // namespace

Result<FeedbackPass> FeedbackPass::create(const BackboneContext& context) {
    auto shader = buildShader(context.gl, "fullscreen.vert", "cubemap/feedback.frag", {"AO_PAGES"});
    if (!shader) {
        return shader.status();
    }
    auto target = gl::RenderToTexture2D::create(
        context.gl, {.width = kSize,
                     .height = kSize,
                     .targets = {gl::RenderToTexture2D::Format::RGBA32F},
                     .label = "aolib/feedback"});
    if (!target) {
        return target.status();
    }
    FeedbackPass pass;
    pass.shader_ = std::move(*shader);
    pass.target_ = std::move(*target);
    return pass;
}

AoStatus FeedbackPass::makeReadbacks(const BackboneContext& context, PendingFeedback& of) const {
    std::vector<PendingFeedback::Request> requests(kMost);
    for (PendingFeedback::Request& request : requests) {
        auto readback =
            gl::PixelReadback::create(context.gl, target_.bytes(), "aolib/feedback/readback");
        if (!readback) {
            return readback.status();
        }
        request.readback = std::move(*readback);
    }
    of.requests_ = std::move(requests);
    return {};
}

AoStatus FeedbackPass::issue(const FrameContext& context, const ProjectedCubeMaps& cubeMaps,
                             std::uint64_t frameNumber, PendingFeedback& into) {
    const gl::DebugGroup group(context.gl, "aolib: feedback");
    if (into.requests_.empty()) {
        if (AoStatus status = makeReadbacks(context, into); !status) {
            return status;
        }
    }
    for (PendingFeedback::Request& request : into.requests_) {
        if (request.readback.pending()) {
            continue;
        }
        target_.bindAsTarget(0);
        Projection::bind(shader_, context, cubeMaps);
        shader_.set("uTargetSize", glm::vec2(kSize));
        context.emptyVertexArray.drawFullscreen();
        target_.bindForReading(0);
        request.readback.start(kSize, kSize, GL_RGBA, GL_FLOAT);
        request.frame = frameNumber;
        request.eye = context.frame.camera.eye();
        request.cubeMaps.clear();
        for (const CubeMapProjector* projector : cubeMaps.list) {
            request.cubeMaps.push_back(projector->id());
        }
        break;
    }
    return {};
}

FeedbackResult PendingFeedback::evaluate(const Request& request,
                                         std::span<const std::uint8_t> pixels) {
    FeedbackResult result{.frame = request.frame,
                          .eye = request.eye,
                          .points = {},
                          .shades = {},
                          .footprints = {},
                          .hiddenFrom = {},
                          .best = {},
                          .projected = request.cubeMaps};
    std::vector<std::size_t> shadedBy(request.cubeMaps.size() + 1, 0);
    std::size_t shaded = 0;
    result.points.reserve(pixels.size() / sizeof(glm::vec4));
    result.footprints.reserve(pixels.size() / sizeof(glm::vec4));
    result.hiddenFrom.reserve(pixels.size() / sizeof(glm::vec4));
    for (std::size_t i = 0; i + sizeof(glm::vec4) <= pixels.size(); i += sizeof(glm::vec4)) {
        glm::vec4 sample;
        std::memcpy(&sample, pixels.data() + i, sizeof(sample));
        if (sample.w != 0.0F) {
            result.points.emplace_back(sample);
            result.shades.push_back(sample.w > 0.0F);
            result.footprints.push_back(std::abs(sample.w));
            const std::size_t cubeMap = std::min(cubeMapOf(sample.w), request.cubeMaps.size());
            const bool hidden = sample.w < 0.0F && cubeMap < request.cubeMaps.size();
            result.hiddenFrom.push_back(hidden ? request.cubeMaps[cubeMap] : CubeMapId{});
            if (sample.w > 0.0F) {
                ++shaded;
                ++shadedBy[cubeMap];
            }
        }
    }
    result.shaded = result.points.empty()
                        ? 1.0F
                        : static_cast<float>(shaded) / static_cast<float>(result.points.size());
    result.surfaces = static_cast<float>(result.points.size()) /
                      static_cast<float>(pixels.size() / sizeof(glm::vec4));
    for (std::size_t i = 0; i < request.cubeMaps.size(); ++i) {
        if (shadedBy[i] > 0) {
            result.best[request.cubeMaps[i]] =
                static_cast<float>(shadedBy[i]) / static_cast<float>(result.points.size());
        }
    }
    return result;
}

std::optional<FeedbackResult> PendingFeedback::poll() {
    std::optional<FeedbackResult> newest;
    for (Request& request : requests_) {
        request.readback.poll([&](std::span<const std::uint8_t> pixels) {
            if (!newest || request.frame > newest->frame) {
                newest = evaluate(request, pixels);
            }
        });
    }
    return newest;
}

void PendingFeedback::restart() {
    for (Request& request : requests_) {
        request.readback.cancel();
    }
}

} // namespace aolib
