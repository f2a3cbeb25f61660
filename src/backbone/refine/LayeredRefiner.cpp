#include "backbone/refine/LayeredRefiner.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "backbone/estimators/Estimators.h"
#include "backbone/frame/ShaderLibrary.h"
#include "gl/Label.h"
#include "gl/StateGuard.h"

namespace aolib {

namespace {

/// Pixels across and up of a tile. A software rasteriser's threads share a picture out in squares
/// of 64 x 64: two of them have something to do.
constexpr glm::ivec2 kPixelTile{128, 4};
/// Slices and steps for each of a texel: pixels are not averaged with their neighbours as texels
/// are, and steps as fine as these miss no thin slab that is seen edge-on (docs/accuracy.md).
constexpr int kSlicesPerTexelSlice = 2;
constexpr int kStepsPerTexelStep = 6;
/// Views of more pixels keep their texels: a capture takes some 140 bytes of each.
constexpr std::int64_t kMostPixels = 4'000'000;
constexpr int kMostSlices = 128;
constexpr int kMostSteps = 256;

constexpr int kSumsUnit = 0; ///< of keep_pixels.frag; in pixels_layered.frag the capture's
constexpr int kHostDepthUnit = 1;

Options ofPixels(const Options& texels) {
    Options options = texels;
    LayeredIntervalsOptions& layered = options.layeredIntervals;
    layered.slices = std::min(kSlicesPerTexelSlice * layered.slices, kMostSlices);
    layered.steps = std::min(kStepsPerTexelStep * layered.steps, kMostSteps);
    return options;
}

/// Corners of the tiles of a view, its middle last.
std::vector<glm::ivec2> tilesOf(const glm::ivec2& size) {
    std::vector<glm::ivec2> tiles;
    for (int y = 0; y < size.y; y += kPixelTile.y) {
        for (int x = 0; x < size.x; x += kPixelTile.x) {
            tiles.emplace_back(x, y);
        }
    }
    const auto fromMiddle = [&](const glm::ivec2& tile) {
        const glm::ivec2 away = 2 * tile + kPixelTile - size;
        return away.x * away.x + away.y * away.y;
    };
    std::stable_sort(tiles.begin(), tiles.end(), [&](const glm::ivec2& a, const glm::ivec2& b) {
        return fromMiddle(a) > fromMiddle(b);
    });
    return tiles;
}

} // namespace

Result<LayeredRefiner::Shared> LayeredRefiner::createShared(const BackboneContext& context) {
    auto visibility = buildShader(context.gl, "fullscreen.vert", "cubemap/pixels_layered.frag");
    if (!visibility) {
        return visibility.status();
    }
    auto keep = buildShader(context.gl, "fullscreen.vert", "cubemap/keep_pixels.frag");
    if (!keep) {
        return keep.status();
    }
    return Shared{std::move(*visibility), std::move(*keep)};
}

void LayeredRefiner::restart() {
    stage_ = Stage::Begin;
    work_.reset();
}

std::size_t LayeredRefiner::bytes() const {
    return work_ ? work_->around.capture->bytes() + work_->sums.bytes() : 0;
}

// ---- Units of work ------------------------------------------------------------------------------

std::optional<WorkUnit> LayeredRefiner::next() {
    switch (stage_) {
    case Stage::Capture:
        return work_->around.capture->next();
    case Stage::Tiles:
        return WorkUnit::Pixels;
    case Stage::Done:
        return std::nullopt;
    default:
        return WorkUnit::Prepare;
    }
}

bool LayeredRefiner::isReady() {
    return stage_ != Stage::Capture || !work_->around.capture->waits();
}

Result<int> LayeredRefiner::step(const StaticView& view, RefinedPixels& pixels, int most) {
    const gl::DebugGroup group(view.context.gl, "aolib: pixels of a view at rest");
    if (stage_ == Stage::Begin) {
        if (AoStatus status = begin(view); !status) {
            return status;
        }
    }
    const auto done = stepStage(view, pixels, most);
    if (!done) {
        restart();
    }
    return done;
}

Result<int> LayeredRefiner::stepStage(const StaticView& view, RefinedPixels& pixels, int most) {
    AoStatus status;
    switch (stage_) {
    case Stage::Capture:
        status = work_->around.capture->step();
        stage_ = work_->around.capture->complete() ? Stage::Targets : stage_;
        break;
    case Stage::Targets:
        status = makeTargets(view, pixels);
        stage_ = Stage::Tiles;
        break;
    case Stage::Tiles:
        return computeTile(view, pixels, most);
    default:
        break;
    }
    if (!status) {
        return status;
    }
    return 1;
}

// ---- What pixels see ----------------------------------------------------------------------------

AoStatus LayeredRefiner::begin(const StaticView& view) {
    const std::int64_t pixels = std::int64_t{view.context.frame.size.x} * view.context.frame.size.y;
    if (view.context.frame.camera.orthographic() ||
        pixels > kMostPixels) { // rays that are parallel have no centre
        stage_ = Stage::Done;
        return {};
    }
    auto around = shading_.surroundings(
        view.context, geometry_, view.context.frame.camera.eye(),
        view.context.options.cubeMaps.faceSize,
        ViewFace::of(view.context.frame.camera, view.context.frame.size, view.context.frame.clip));
    if (!around) {
        return around.status();
    }
    work_ =
        Work{.around = std::move(*around), .sums = {}, .tiles = tilesOf(view.context.frame.size)};
    stage_ = Stage::Capture;
    return {};
}

AoStatus LayeredRefiner::makeTargets(const StaticView& view, RefinedPixels& pixels) {
    const gl::Functions& gl = view.context.gl;
    const glm::ivec2& size = view.context.frame.size;
    pixels.count = 0;
    if (AoStatus status = pixels.makeRoom(gl, size); !status) {
        return status;
    }
    auto sums =
        gl::RenderToTexture2D::create(gl, {.width = size.x,
                                           .height = size.y,
                                           .targets = {gl::RenderToTexture2D::Format::RG32F},
                                           .label = "aolib/refiner/sums"});
    if (sums) {
        constexpr std::array<GLfloat, 4> kNoWeight{};
        work_->sums = std::move(*sums);
        work_->sums.bindAsTarget(0);
        gl.ClearBufferfv(GL_COLOR, 0, kNoWeight.data());
    }
    return sums.status();
}

// ---- Pixels -------------------------------------------------------------------------------------

int LayeredRefiner::computeTile(const StaticView& view, RefinedPixels& pixels, int most) {
    const int slices = ofPixels(view.context.options).layeredIntervals.slices;
    const glm::ivec2 tile = work_->tiles.back();
    const int count = std::min(most, slices - work_->slices);
    accumulate(view, tile, work_->slices, count);
    work_->slices += count;
    if (work_->slices == slices) {
        keep(view, pixels, tile);
        const glm::ivec2 extent = glm::min(kPixelTile, view.context.frame.size - tile);
        pixels.count += static_cast<std::size_t>(extent.x) * static_cast<std::size_t>(extent.y);
        work_->slices = 0;
        work_->tiles.pop_back();
    }
    if (work_->tiles.empty()) {
        work_.reset();
        stage_ = Stage::Done;
    }
    return count;
}

void LayeredRefiner::accumulate(const StaticView& view, const glm::ivec2& tile, int first,
                                int count) {
    const FrameContext& context = view.context;
    const gl::Functions& gl = context.gl;
    const glm::ivec2 extent = glm::min(kPixelTile, view.context.frame.size - tile);
    work_->sums.bindAsTarget(0);
    gl::setViewport(gl, tile.x, tile.y, extent.x, extent.y);
    shared_.visibility.bind();
    work_->around.capture->bind(shared_.visibility);
    view.context.host.bindDepth(kHostDepthUnit);
    shared_.visibility.set("uDepth", kHostDepthUnit);
    view.context.frame.camera.setUniforms(shared_.visibility, view.context.frame.size,
                                          view.context.frame.clip);
    shared_.visibility.set("uFirstSlice", first);
    shared_.visibility.set("uSliceCount", count);
    setEstimatorUniforms(shared_.visibility, ofPixels(context.options));
    gl::beginBlending(gl, GL_ONE, GL_ONE, GL_ONE, GL_ONE);
    context.emptyVertexArray.drawFullscreen();
    gl::endBlending(gl);
}

void LayeredRefiner::keep(const StaticView& view, const RefinedPixels& pixels,
                          const glm::ivec2& tile) {
    const glm::ivec2 extent = glm::min(kPixelTile, view.context.frame.size - tile);
    pixels.texture()->bindAsTarget(0);
    gl::setViewport(view.context.gl, tile.x, tile.y, extent.x, extent.y);
    shared_.keep.bind();
    work_->sums.bindTexture(0, kSumsUnit);
    view.context.host.bindDepth(kHostDepthUnit);
    shared_.keep.set("uSums", kSumsUnit);
    shared_.keep.set("uDepth", kHostDepthUnit);
    view.context.emptyVertexArray.drawFullscreen();
}

} // namespace aolib
