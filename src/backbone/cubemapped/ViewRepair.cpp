#include "backbone/cubemapped/ViewRepair.h"

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
/// What is stored where a pixel was not traced: no depth is negative.
constexpr glm::vec2 kNotTraced{1.0F, -1.0F};

constexpr auto kAsker = TracerQueue::Asker::Pixels;

} // namespace

Result<ViewRepair> ViewRepair::create(const BackboneContext& context) {
    auto shader = buildShader(context.gl, "fullscreen.vert", "cubemap/doubt.frag", {"AO_DETAIL"});
    if (!shader) {
        return shader.status();
    }
    ViewRepair repair;
    repair.shader_ = std::move(*shader);
    return repair;
}

void ViewRepair::restart() {
    lookAgain();
    repaired_.reset();
    pixels_ = 0;
}

void ViewRepair::lookAgain() {
    phase_ = Phase::Waiting;
    ++generation_;
    doubt_ = {};
    readback_ = {};
    tiles_.clear();
}

void ViewRepair::follow(const Frame& frame) {
    View view{frame.camera, frame.size, frame.clip};
    if (view_ == view) {
        ++framesAtRest_;
        return;
    }
    view_ = view;
    framesAtRest_ = 0;
    if (phase_ != Phase::Waiting || repaired_) {
        restart();
    }
}

Status ViewRepair::advance(const BackboneContext& context, const Frame& frame,
                           const HostFramebuffer& host, const KeptTexels& kept,
                           const std::vector<CubeMapProjector*>& projectors, TracerQueue& queue,
                           float radius, double milliseconds) {
    const auto start = std::chrono::steady_clock::now();
    const bool toTheEnd = std::isinf(milliseconds);
    if (phase_ == Phase::Waiting) {
        if (Status status = ask(context, frame, host, kept, projectors); !status) {
            return status;
        }
    }
    if (phase_ == Phase::Asked) {
        if (toTheEnd) {
            context.gl.Finish();
        }
        Status status;
        readback_.poll([&](auto depths) { status = plan(context.gl, depths); });
        if (!status) {
            restart();
            return status;
        }
    }
    while (phase_ == Phase::Tracing) {
        if (queue.pending(kAsker) == 0) {
            queue.request(kAsker, requests(context, radius));
        }
        if (toTheEnd) {
            queue.wait(1000.0);
        }
        const std::vector<TracedTexels> results = queue.take(kAsker, 1);
        if (!queue.status()) {
            return queue.status();
        }
        for (const TracedTexels& traced : results) {
            take(traced);
        }
        const std::chrono::duration<double, std::milli> spent =
            std::chrono::steady_clock::now() - start;
        if (!toTheEnd && (results.empty() || spent.count() >= milliseconds)) {
            break;
        }
    }
    return {};
}

Status ViewRepair::ask(const BackboneContext& context, const Frame& frame,
                       const HostFramebuffer& host, const KeptTexels& kept,
                       const std::vector<CubeMapProjector*>& projectors) {
    const gl::DebugGroup group(context.gl, "aolib: doubtful pixels");
    auto doubt =
        gl::RenderToTexture2D::create(context.gl, {.width = frame.size.x,
                                                   .height = frame.size.y,
                                                   .targets = {gl::RenderToTexture2D::Format::R32F},
                                                   .label = "aolib/repair/doubt"});
    if (!doubt) {
        return doubt.status();
    }
    auto readback = gl::PixelReadback::create(context.gl, doubt->bytes(), "aolib/repair/readback");
    if (!readback) {
        return readback.status();
    }
    doubt_ = std::move(*doubt);
    readback_ = std::move(*readback);
    doubt_.begin(0);
    Projection::bind(shader_, frame, host, kept, projectors);
    context.generated.drawFullscreen();
    doubt_.beginRead(0);
    readback_.start(frame.size.x, frame.size.y, GL_RED, GL_FLOAT);
    phase_ = Phase::Asked;
    return {};
}

Status ViewRepair::plan(const gl::Functions& gl, std::span<const std::uint8_t> depths) {
    const glm::ivec2 size = view_->size;
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
                    const float depth =
                        rows[static_cast<std::size_t>(at.y) * static_cast<std::size_t>(size.x) +
                             static_cast<std::size_t>(at.x)];
                    if (depth >= 0.0F) {
                        tile.push_back({at, depth});
                    }
                }
            }
            if (!tile.empty()) {
                tiles_.push_back(std::move(tile));
            }
        }
    }
    doubt_ = {};
    pixels_ = 0;
    phase_ = tiles_.empty() ? Phase::Done : Phase::Tracing;
    if (tiles_.empty() || repaired_) {
        return {};
    }
    auto created = gl::TextureStack::create(gl, {.width = size.x,
                                                 .height = size.y,
                                                 .layers = 1,
                                                 .format = gl::RenderToTexture2D::Format::RG32F,
                                                 .label = "aolib/repair/pixels"});
    if (!created) {
        return created.status();
    }
    repaired_ = std::move(*created);
    repaired_->begin(0);
    const std::array<float, 4> none{kNotTraced.x, kNotTraced.y, 0.0F, 0.0F};
    gl.ClearBufferfv(GL_COLOR, 0, none.data());
    return {};
}

std::vector<TexelRequest> ViewRepair::requests(const BackboneContext& context, float radius) const {
    const HostCamera& camera = view_->camera;
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
                             .rays = kRaysPerTexelRay * context.options.rayTraced.rays,
                             .radius = radius,
                             .falloff = context.options.falloff,
                             .sights = {}};
        for (const Pixel& pixel : pixels) {
            const HostCamera::Surface surface = camera.surfaceAt(
                pixel.at, static_cast<double>(pixel.depth), view_->size, view_->clip);
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

void ViewRepair::take(const TracedTexels& traced) {
    const std::uint64_t key = traced.request.key;
    const std::size_t number = key & ((1U << kRepairTileBits) - 1U);
    if (key >> kRepairTileBits != generation_ || tiles_[number].empty()) {
        return; // of another view, or traced twice
    }
    std::vector<Pixel>& tile = tiles_[number];
    const glm::ivec2 origin = tile.front().at / kTile * kTile;
    const glm::ivec2 extent = glm::min(glm::ivec2(kTile), view_->size - origin);
    std::vector<glm::vec2> texels(
        static_cast<std::size_t>(extent.x) * static_cast<std::size_t>(extent.y), kNotTraced);
    for (std::size_t i = 0; i < tile.size(); ++i) {
        if (traced.distance[i] < 0.0F) {
            continue; // the host draws what the scene does not have
        }
        const glm::ivec2 at = tile[i].at - origin;
        texels[static_cast<std::size_t>(at.y) * static_cast<std::size_t>(extent.x) +
               static_cast<std::size_t>(at.x)] = {traced.visibility[i], tile[i].depth};
        ++pixels_;
    }
    repaired_->upload(0, origin, extent, texels.data());
    tile.clear();
    const bool left = std::any_of(tiles_.begin(), tiles_.end(),
                                  [](const auto& pixels) { return !pixels.empty(); });
    phase_ = left ? phase_ : Phase::Done;
}

std::size_t ViewRepair::bytes() const {
    return (repaired_ ? repaired_->bytes() : 0) + (doubt_ ? 2 * doubt_.bytes() : 0);
}

} // namespace aolib
