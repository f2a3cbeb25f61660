#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "backbone/refine/AbstractPixelRefiner.h"
#include "backbone/texels/TracerQueue.h"
#include "gl/PixelReadback.h"

namespace aolib {

/// Traces the pixels of low confidence, as at edges finer than any texel, along their own
/// lines of sight.
class RayTracedRefiner final : public AbstractPixelRefiner {
public:
    /// Makes the shader that finds pixels of low confidence, for all views. Errors: ShaderError.
    static Result<gl::GLSLShader> createShader(const BackboneContext& context);
    /// @param shader, queue  outlive it.
    /// @param slot           of the view, which none else has.
    RayTracedRefiner(gl::GLSLShader& shader, TracerQueue& queue, unsigned slot)
        : queue_(queue), client_(TracerQueue::pixelsOf(slot)), shader_(shader),
          generation_(queue.nextGeneration()) {}
    ~RayTracedRefiner() override { RayTracedRefiner::restart(); }

    void restart() override;
    void invalidate() override { restart(); }
    bool isAltered(const Bounds& within, bool texels) const override;
    std::optional<WorkUnit> next() override;
    bool isReady() override;
    /// Errors: OutOfMemory, MissingCapability, the tracer's.
    Result<int> step(const StaticView& view, RefinedPixels& pixels, int most) override;
    void await(const StaticView& view, double milliseconds) override;
    bool done() const override { return phase_ == Phase::Done; }
    std::size_t bytes() const override { return lowConfidence_ ? 2 * lowConfidence_.bytes() : 0; }

private:
    enum class Phase : std::uint8_t { Waiting, Reading, Tracing, Done };
    struct Pixel {
        glm::ivec2 at; ///< in the frame
        float depth;   ///< as HostFramebuffer has it
        /// Where its surface is seen: x and y in the pixel, 0 to 1, and the host's depth there.
        glm::vec3 seen;
    };

    /// Draws where cube maps have low confidence, and starts reading it back.
    AoStatus findPixels(const StaticView& view);
    /// Reads it, and sorts the pixels of low confidence into tiles.
    AoStatus readPixels(const StaticView& view, RefinedPixels& pixels);
    static Bounds surfacesOf(const std::vector<Pixel>& pixels, const Frame& frame);
    void plan(const Frame& frame, std::span<const std::uint8_t> depths);
    /// The shader for a host with samples, or for one without. Errors: ShaderError.
    Result<gl::GLSLShader*> shaderFor(const StaticView& view);
    /// Takes traced pixels, and requests more.
    Result<int> takePixels(const StaticView& view, RefinedPixels& pixels, int most);
    std::vector<TexelRequest> requests(const StaticView& view) const;
    void take(const TracedTexels& traced, const glm::ivec2& size, RefinedPixels& pixels);

    TracerQueue& queue_;
    const TracerQueue::Client client_;
    gl::GLSLShader& shader_;
    std::optional<gl::GLSLShader> sampled_; ///< of hosts with samples; built for the first
    Phase phase_ = Phase::Waiting;
    std::uint32_t generation_;            ///< results of another are out of date
    gl::RenderToTexture2D lowConfidence_; ///< while it is read back
    std::size_t channels_ = 1;            ///< of lowConfidence_
    gl::PixelReadback readback_;
    std::vector<std::vector<Pixel>>
        tiles_;                    ///< pixels of low confidence; empty once they are traced
    std::vector<Bounds> surfaces_; ///< that the pixels of each tile show, world units
};

} // namespace aolib
