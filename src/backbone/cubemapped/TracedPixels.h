#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "backbone/cubemapped/AbstractPixelSource.h"
#include "backbone/cubemapped/TracerQueue.h"
#include "gl/PixelReadback.h"

namespace aolib {

/// Traces those pixels that no texel quite tells, as at edges finer than any texel, along their own
/// lines of sight.
class TracedPixels final : public AbstractPixelSource {
public:
    /// Finds the doubtful pixels of all views. Errors: ShaderError.
    static Result<gl::GLSLShader> createShader(const BackboneContext& context);
    /// @param shader, queue  outlive it.
    /// @param slot           of the view, which none else has.
    TracedPixels(gl::GLSLShader& shader, TracerQueue& queue, unsigned slot)
        : queue_(queue), asker_(TracerQueue::pixelsOf(slot)), shader_(shader),
          generation_(queue.nextGeneration()) {}
    ~TracedPixels() override { TracedPixels::restart(); }

    void restart() override;
    void lookAgain() override { restart(); }
    bool isAltered(const Bounds& within, bool texels) const override;
    /// Errors: OutOfMemory, MissingCapability, the tracer's.
    AoStatus advance(const RestingView& view, FoundPixels& found, double milliseconds) override;
    bool done() const override { return phase_ == Phase::Done; }
    std::size_t bytes() const override { return doubt_ ? 2 * doubt_.bytes() : 0; }

private:
    enum class Phase : std::uint8_t { Waiting, Asked, Tracing, Done };
    struct Pixel {
        glm::ivec2 at; ///< in the frame
        float depth;   ///< as HostFramebuffer has it
        /// Where its surface is seen: x and y in the pixel, 0 to 1, and the host's depth there.
        glm::vec3 seen;
    };

    /// Draws where the cube maps leave a doubt, and starts reading it back.
    AoStatus ask(const RestingView& view);
    static Bounds surfacesOf(const std::vector<Pixel>& pixels, const Frame& frame);
    /// Sorts the doubtful pixels into tiles.
    void plan(const Frame& frame, std::span<const std::uint8_t> depths);
    /// The shader for a host with samples, or for one without. Errors: ShaderError.
    Result<gl::GLSLShader*> shaderFor(const RestingView& view);
    /// Traces them.
    AoStatus trace(const RestingView& view, FoundPixels& found, double milliseconds);
    std::vector<TexelRequest> requests(const RestingView& view) const;
    void take(const TracedTexels& traced, const glm::ivec2& size, FoundPixels& found);

    TracerQueue& queue_;
    const TracerQueue::Asker asker_;
    gl::GLSLShader& shader_;
    std::optional<gl::GLSLShader> sampled_; ///< of hosts with samples; built for the first
    Phase phase_ = Phase::Waiting;
    std::uint32_t generation_;    ///< results of another are out of date
    gl::RenderToTexture2D doubt_; ///< while it is read back
    std::size_t channels_ = 1;    ///< of doubt_
    gl::PixelReadback readback_;
    std::vector<std::vector<Pixel>> tiles_; ///< doubtful pixels; empty once they are traced
    std::vector<Bounds> surfaces_;          ///< that the pixels of each tile show, world units
};

} // namespace aolib
