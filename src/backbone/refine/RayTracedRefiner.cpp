#include "backbone/refine/RayTracedRefiner.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "backbone/frame/ShaderLibrary.h"
#include "gl/Label.h"

namespace aolib {

namespace {

constexpr int kTile = 32;           ///< pixels along a tile's edge, a request's worth
constexpr int kBlock = 4;           ///< pixels along the edge of what is traced side by side
constexpr int kRepairTileBits = 24; ///< of a request's key
/// Requests queued at a time: enough to keep workers busy between frames.
constexpr std::size_t kRepairQueue = 64;
/// A pixel's surface is looked for within this share of its footprint.
constexpr double kReach = 0.25;
/// Rays of a pixel for each of a texel: pixels are not averaged with their neighbours as the four
/// texels about a point are.
constexpr int kRaysPerTexelRay = 4;

/// Channels of what low_confidence.frag writes, without and with samples.
constexpr std::size_t kDepthAlone = 1;
constexpr std::size_t kDepthAndSeen = 4;
constexpr int kDoubtEdgesUnit = 6;
constexpr float kPixelCentre = 0.5F; ///< of a pixel

} // namespace

Result<gl::GLSLShader> RayTracedRefiner::createShader(const BackboneContext& context) {
    return buildShader(context.gl, "fullscreen.vert", "cubemap/low_confidence.frag", {"AO_PAGES"});
}

void RayTracedRefiner::restart() {
    if (phase_ == Phase::Tracing) {
        queue_.drop(client_);
    }
    phase_ = Phase::Waiting;
    generation_ = queue_.nextGeneration();
    lowConfidence_ = {};
    readback_ = {};
    tiles_.clear();
    surfaces_.clear();
}

std::optional<WorkUnit> RayTracedRefiner::next() {
    switch (phase_) {
    case Phase::Waiting:
        return WorkUnit::Prepare;
    case Phase::Reading:
    case Phase::Tracing:
        return WorkUnit::Upload;
    case Phase::Done:
        break;
    }
    return std::nullopt;
}

bool RayTracedRefiner::isReady() {
    switch (phase_) {
    case Phase::Reading:
        return readback_.arrived();
    case Phase::Tracing:
        return queue_.hasResult(client_) || queue_.pending(client_) == 0 || !queue_.status();
    default:
        return true;
    }
}

void RayTracedRefiner::await(const StaticView& view, double milliseconds) {
    if (phase_ == Phase::Reading) {
        view.context.gl.Finish();
    } else {
        queue_.wait(milliseconds);
    }
}

Result<int> RayTracedRefiner::step(const StaticView& view, RefinedPixels& pixels, int most) {
    if (phase_ == Phase::Tracing) {
        return takePixels(view, pixels, most);
    }
    AoStatus status = phase_ == Phase::Waiting ? findPixels(view) : readPixels(view, pixels);
    if (!status) {
        return status;
    }
    return 1;
}

AoStatus RayTracedRefiner::readPixels(const StaticView& view, RefinedPixels& pixels) {
    const Frame& frame = view.context.frame;
    if (!readback_.finish([&](auto depths) { plan(frame, depths); })) {
        restart();
        return {StatusCode::OutOfMemory, "aolib/refiner: mapping the readback buffer failed"};
    }
    if (phase_ != Phase::Tracing) {
        return {};
    }
    pixels.count = 0;
    AoStatus status = pixels.makeRoom(view.context.gl, frame.size);
    if (!status) {
        restart();
    }
    return status;
}

Result<int> RayTracedRefiner::takePixels(const StaticView& view, RefinedPixels& pixels, int most) {
    if (!queue_.status()) {
        return queue_.status();
    }
    const std::vector<TracedTexels> results = queue_.take(client_, static_cast<std::size_t>(most));
    for (const TracedTexels& traced : results) {
        take(traced, view.context.frame.size, pixels);
    }
    if (phase_ == Phase::Tracing && queue_.pending(client_) == 0) {
        queue_.request(client_, requests(view));
    }
    return static_cast<int>(results.size());
}

Result<gl::GLSLShader*> RayTracedRefiner::shaderFor(const StaticView& view) {
    const HostSamples* samples = view.context.host.samples();
    if (samples == nullptr) {
        return &shader_;
    }
    if (!sampled_) {
        auto shader = buildShader(view.context.gl, "fullscreen.vert", "cubemap/low_confidence.frag",
                                  {"AO_PAGES", "AO_SAMPLES"});
        if (!shader) {
            return shader.status();
        }
        sampled_ = std::move(*shader);
    }
    sampled_->bind();
    samples->setUniforms(*sampled_);
    samples->bindEdges(kDoubtEdgesUnit);
    sampled_->set("uEdges", kDoubtEdgesUnit);
    return &*sampled_;
}

AoStatus RayTracedRefiner::findPixels(const StaticView& view) {
    const gl::Functions& gl = view.context.gl;
    const glm::ivec2& size = view.context.frame.size;
    const gl::DebugGroup group(gl, "aolib: pixels of low confidence");
    using Format = gl::RenderToTexture2D::Format;
    const HostSamples* samples = view.context.host.samples();
    channels_ = samples == nullptr ? kDepthAlone : kDepthAndSeen;
    const auto shader = shaderFor(view);
    if (!shader) {
        return shader.status();
    }
    auto found = gl::RenderToTexture2D::create(
        gl, {.width = size.x,
             .height = size.y,
             .targets = {samples == nullptr ? Format::R32F : Format::RGBA32F},
             .label = "aolib/refiner/confidence"});
    if (!found) {
        return found.status();
    }
    auto readback = gl::PixelReadback::create(gl, found->bytes(), "aolib/refiner/readback");
    if (!readback) {
        return readback.status();
    }
    lowConfidence_ = std::move(*found);
    readback_ = std::move(*readback);
    lowConfidence_.bindAsTarget(0);
    Projection::bind(**shader, view.context, view.cubeMaps);
    if (samples == nullptr) {
        view.context.emptyVertexArray.drawFullscreen();
    } else {
        const gl::MultisampleBinding binding = samples->bindSamples(gl);
        view.context.emptyVertexArray.drawFullscreen();
    }
    lowConfidence_.bindForReading(0);
    readback_.start(size.x, size.y, samples == nullptr ? GL_RED : GL_RGBA, GL_FLOAT);
    phase_ = Phase::Reading;
    return {};
}

bool RayTracedRefiner::isAltered(const Bounds& within, bool /*texels*/) const {
    return std::ranges::any_of(surfaces_, [&](const Bounds& seen) { return seen.meets(within); });
}

Bounds RayTracedRefiner::surfacesOf(const std::vector<Pixel>& pixels, const Frame& frame) {
    Bounds bounds;
    float footprint = 0.0F;
    for (const Pixel& pixel : pixels) {
        const HostCamera::Surface surface =
            frame.camera.surfaceAt(pixel.at, static_cast<double>(pixel.seen.z), frame.size,
                                   frame.clip, glm::dvec2(pixel.seen));
        bounds.include(glm::vec3(frame.camera.eye() + surface.position));
        footprint = std::max(footprint, static_cast<float>(surface.footprint));
    }
    return bounds.inflated(footprint);
}

void RayTracedRefiner::plan(const Frame& frame, std::span<const std::uint8_t> depths) {
    const glm::ivec2 size = frame.size;
    std::vector<float> rows(depths.size() / sizeof(float));
    std::memcpy(rows.data(), depths.data(), rows.size() * sizeof(float));
    for (int y = 0; y < size.y; y += kTile) {
        for (int x = 0; x < size.x; x += kTile) {
            std::vector<Pixel> tile;
            for (int i = 0; i < kTile * kTile; ++i) { // block by block
                const int block = i / (kBlock * kBlock);
                const int inBlock = i % (kBlock * kBlock);
                constexpr int kBlocks = kTile / kBlock;
                const glm::ivec2 at(x + block % kBlocks * kBlock + inBlock % kBlock,
                                    y + block / kBlocks * kBlock + inBlock / kBlock);
                if (at.x < size.x && at.y < size.y) {
                    const float* sample = &rows[channels_ * (static_cast<std::size_t>(at.y) *
                                                                 static_cast<std::size_t>(size.x) +
                                                             static_cast<std::size_t>(at.x))];
                    if (sample[0] >= 0.0F) {
                        tile.push_back({at, sample[0],
                                        channels_ == kDepthAlone
                                            ? glm::vec3(kPixelCentre, kPixelCentre, sample[0])
                                            : glm::vec3(sample[1], sample[2], sample[3])});
                    }
                }
            }
            if (!tile.empty()) {
                surfaces_.push_back(surfacesOf(tile, frame));
                tiles_.push_back(std::move(tile));
            }
        }
    }
    lowConfidence_ = {};
    phase_ = tiles_.empty() ? Phase::Done : Phase::Tracing;
}

std::vector<TexelRequest> RayTracedRefiner::requests(const StaticView& view) const {
    const HostCamera& camera = view.context.frame.camera;
    const Options& options = view.context.options;
    const glm::vec3 centre(camera.eye());
    const glm::dvec3 rest = camera.eye() - glm::dvec3(centre);
    std::vector<TexelRequest> queue;
    for (std::size_t tile = 0; tile < tiles_.size() && queue.size() < kRepairQueue; ++tile) {
        const std::vector<Pixel>& pixels = tiles_[tile];
        if (pixels.empty()) {
            continue;
        }
        TexelRequest request{.key = std::uint64_t{generation_} << kRepairTileBits | tile,
                             .centre = centre,
                             .faceSize = kTile,
                             .x = pixels.front().at.x,
                             .y = pixels.front().at.y,
                             .width = kBlock,
                             .height = static_cast<int>(pixels.size() + kBlock - 1) / kBlock,
                             .rays = kRaysPerTexelRay * options.rayTraced.rays,
                             .radius = options.radius,
                             .falloff = options.falloff,
                             .primaryRays = {}};
        for (const Pixel& pixel : pixels) {
            const HostCamera::Surface surface = camera.surfaceAt(
                pixel.at, static_cast<double>(pixel.seen.z), view.context.frame.size,
                view.context.frame.clip, glm::dvec2(pixel.seen));
            const glm::dvec3 reach =
                (2.0 * surface.resolution + kReach * surface.footprint) * surface.viewer;
            request.primaryRays.push_back({glm::vec3(rest + surface.position + reach),
                                           glm::vec3(rest + surface.position - reach)});
        }
        while (request.primaryRays.size() % kBlock != 0) {
            request.primaryRays.push_back(request.primaryRays.back());
        }
        queue.push_back(std::move(request));
    }
    return queue;
}

void RayTracedRefiner::take(const TracedTexels& traced, const glm::ivec2& size,
                            RefinedPixels& pixels) {
    const std::uint64_t key = traced.request.key;
    const std::size_t number = key & ((1U << kRepairTileBits) - 1U);
    if (key >> kRepairTileBits != generation_ || tiles_[number].empty()) {
        return; // of another view, or traced twice
    }
    std::vector<Pixel>& tile = tiles_[number];
    const glm::ivec2 origin = tile.front().at / kTile * kTile;
    const glm::ivec2 extent = glm::min(glm::ivec2(kTile), size - origin);
    std::vector<glm::vec2> texels(static_cast<std::size_t>(extent.x) *
                                      static_cast<std::size_t>(extent.y),
                                  RefinedPixels::kNothing);
    for (std::size_t i = 0; i < tile.size(); ++i) {
        if (traced.distance[i] < 0.0F) {
            continue; // the host draws what the scene does not have
        }
        const glm::ivec2 at = tile[i].at - origin;
        texels[static_cast<std::size_t>(at.y) * static_cast<std::size_t>(extent.x) +
               static_cast<std::size_t>(at.x)] = {traced.visibility[i], tile[i].depth};
        ++pixels.count;
    }
    pixels.texture()->upload(0, origin, extent, texels.data());
    tile.clear();
    const bool left = std::any_of(tiles_.begin(), tiles_.end(),
                                  [](const auto& ofTile) { return !ofTile.empty(); });
    phase_ = left ? phase_ : Phase::Done;
}

} // namespace aolib
