#include "backbone/cubemapped/TracedPixels.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <utility>

#include "backbone/ShaderLibrary.h"
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

/// Channels of what doubt.frag writes, without and with samples.
constexpr std::size_t kDepthAlone = 1;
constexpr std::size_t kDepthAndSeen = 4;
constexpr int kDoubtEdgesUnit = 6;
constexpr float kPixelCentre = 0.5F; ///< of a pixel

} // namespace

Result<gl::GLSLShader> TracedPixels::createShader(const BackboneContext& context) {
    return buildShader(context.gl, "fullscreen.vert", "cubemap/doubt.frag", {"AO_BLOCKS"});
}

void TracedPixels::restart() {
    if (phase_ == Phase::Tracing) {
        queue_.drop(asker_);
    }
    phase_ = Phase::Waiting;
    generation_ = queue_.nextGeneration();
    doubt_ = {};
    readback_ = {};
    tiles_.clear();
    surfaces_.clear();
}

AoStatus TracedPixels::advance(const RestingView& view, FoundPixels& found, double milliseconds) {
    if (phase_ == Phase::Waiting) {
        if (AoStatus status = ask(view); !status) {
            return status;
        }
    }
    if (phase_ == Phase::Asked) {
        if (std::isinf(milliseconds)) {
            view.context.gl.Finish();
        }
        readback_.poll([&](auto depths) { plan(view.context.frame, depths); });
        if (phase_ == Phase::Tracing) {
            found.count = 0;
            if (AoStatus status = found.makeRoom(view.context.gl, view.context.frame.size);
                !status) {
                restart();
                return status;
            }
        }
    }
    return phase_ == Phase::Tracing ? trace(view, found, milliseconds) : AoStatus();
}

AoStatus TracedPixels::trace(const RestingView& view, FoundPixels& found, double milliseconds) {
    const auto start = std::chrono::steady_clock::now();
    const bool toTheEnd = std::isinf(milliseconds);
    while (phase_ == Phase::Tracing) {
        if (queue_.pending(asker_) == 0) {
            queue_.request(asker_, requests(view));
        }
        if (toTheEnd) {
            queue_.wait(1000.0);
        }
        const std::vector<TracedTexels> results = queue_.take(asker_, 1);
        if (!queue_.status()) {
            return queue_.status();
        }
        for (const TracedTexels& traced : results) {
            take(traced, view.context.frame.size, found);
        }
        const std::chrono::duration<double, std::milli> spent =
            std::chrono::steady_clock::now() - start;
        if (!toTheEnd && (results.empty() || spent.count() >= milliseconds)) {
            break;
        }
    }
    return {};
}

Result<gl::GLSLShader*> TracedPixels::shaderFor(const RestingView& view) {
    const HostSamples* samples = view.context.host.samples();
    if (samples == nullptr) {
        return &shader_;
    }
    if (!sampled_) {
        auto shader = buildShader(view.context.gl, "fullscreen.vert", "cubemap/doubt.frag",
                                  {"AO_BLOCKS", "AO_SAMPLES"});
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

AoStatus TracedPixels::ask(const RestingView& view) {
    const gl::Functions& gl = view.context.gl;
    const glm::ivec2& size = view.context.frame.size;
    const gl::DebugGroup group(gl, "aolib: doubtful pixels");
    using Format = gl::RenderToTexture2D::Format;
    const HostSamples* samples = view.context.host.samples();
    channels_ = samples == nullptr ? kDepthAlone : kDepthAndSeen;
    const auto shader = shaderFor(view);
    if (!shader) {
        return shader.status();
    }
    auto doubt = gl::RenderToTexture2D::create(
        gl, {.width = size.x,
             .height = size.y,
             .targets = {samples == nullptr ? Format::R32F : Format::RGBA32F},
             .label = "aolib/repair/doubt"});
    if (!doubt) {
        return doubt.status();
    }
    auto readback = gl::PixelReadback::create(gl, doubt->bytes(), "aolib/repair/readback");
    if (!readback) {
        return readback.status();
    }
    doubt_ = std::move(*doubt);
    readback_ = std::move(*readback);
    doubt_.begin(0);
    Projection::bind(**shader, view.context, view.cubeMaps);
    if (samples == nullptr) {
        view.context.generated.drawFullscreen();
    } else {
        const gl::MultisampleBinding binding = samples->bindSamples(gl);
        view.context.generated.drawFullscreen();
    }
    doubt_.beginRead(0);
    readback_.start(size.x, size.y, samples == nullptr ? GL_RED : GL_RGBA, GL_FLOAT);
    phase_ = Phase::Asked;
    return {};
}

bool TracedPixels::isAltered(const Bounds& within, bool /*texels*/) const {
    return std::ranges::any_of(surfaces_, [&](const Bounds& seen) { return seen.meets(within); });
}

Bounds TracedPixels::surfacesOf(const std::vector<Pixel>& pixels, const Frame& frame) {
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

void TracedPixels::plan(const Frame& frame, std::span<const std::uint8_t> depths) {
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
                    const float* doubt = &rows[channels_ * (static_cast<std::size_t>(at.y) *
                                                                static_cast<std::size_t>(size.x) +
                                                            static_cast<std::size_t>(at.x))];
                    if (doubt[0] >= 0.0F) {
                        tile.push_back({at, doubt[0],
                                        channels_ == kDepthAlone
                                            ? glm::vec3(kPixelCentre, kPixelCentre, doubt[0])
                                            : glm::vec3(doubt[1], doubt[2], doubt[3])});
                    }
                }
            }
            if (!tile.empty()) {
                surfaces_.push_back(surfacesOf(tile, frame));
                tiles_.push_back(std::move(tile));
            }
        }
    }
    doubt_ = {};
    phase_ = tiles_.empty() ? Phase::Done : Phase::Tracing;
}

std::vector<TexelRequest> TracedPixels::requests(const RestingView& view) const {
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
                             .sights = {}};
        for (const Pixel& pixel : pixels) {
            const HostCamera::Surface surface = camera.surfaceAt(
                pixel.at, static_cast<double>(pixel.seen.z), view.context.frame.size,
                view.context.frame.clip, glm::dvec2(pixel.seen));
            const glm::dvec3 reach =
                (2.0 * surface.resolution + kReach * surface.footprint) * surface.viewer;
            request.sights.push_back({glm::vec3(rest + surface.position + reach),
                                      glm::vec3(rest + surface.position - reach)});
        }
        while (request.sights.size() % kBlock != 0) {
            request.sights.push_back(request.sights.back());
        }
        queue.push_back(std::move(request));
    }
    return queue;
}

void TracedPixels::take(const TracedTexels& traced, const glm::ivec2& size, FoundPixels& found) {
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
                                  FoundPixels::kNothing);
    for (std::size_t i = 0; i < tile.size(); ++i) {
        if (traced.distance[i] < 0.0F) {
            continue; // the host draws what the scene does not have
        }
        const glm::ivec2 at = tile[i].at - origin;
        texels[static_cast<std::size_t>(at.y) * static_cast<std::size_t>(extent.x) +
               static_cast<std::size_t>(at.x)] = {traced.visibility[i], tile[i].depth};
        ++found.count;
    }
    found.texture()->upload(0, origin, extent, texels.data());
    tile.clear();
    const bool left = std::any_of(tiles_.begin(), tiles_.end(),
                                  [](const auto& pixels) { return !pixels.empty(); });
    phase_ = left ? phase_ : Phase::Done;
}

} // namespace aolib
