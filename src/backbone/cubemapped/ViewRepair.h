#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "backbone/cubemapped/Projection.h"
#include "backbone/cubemapped/TracerQueue.h"
#include "gl/PixelReadback.h"
#include "gl/TextureStack.h"

namespace aolib {

/// The last step to the ray-traced picture, for a view at rest whose cube maps are complete: pixels
/// that no texel quite tells, as at edges finer than any texel, are traced themselves. It lasts
/// until the view moves, and holds for a pixel as long as the host draws the same depth there.
class ViewRepair {
public:
    /// Errors: ShaderError.
    static Result<ViewRepair> create(const BackboneContext& context);

    /// Notes a frame: forgets everything when it shows another view than the frame before.
    void follow(const Frame& frame);
    /// Forgets everything: the scene has changed, or what is asked about it.
    void restart();
    /// Looks for doubtful pixels again: the cube maps have changed. What was traced stays shown.
    void lookAgain();

    /// Goes on for as long as the budget lasts, or to the end. Only while `rests()`.
    /// @param milliseconds  infinite: to the end
    /// Errors: OutOfMemory, MissingCapability, the tracer's.
    Status advance(const BackboneContext& context, const Frame& frame, const HostFramebuffer& host,
                   const KeptTexels& kept, const std::vector<CubeMapProjector*>& projectors,
                   TracerQueue& queue, float radius, double milliseconds);
    /// Whether the latest frame showed what the one before had shown.
    bool rests() const { return framesAtRest_ > 0; }
    /// Whether it waits for rays.
    bool tracing() const { return phase_ == Phase::Tracing; }
    /// Whether nothing is left to repair.
    bool done() const { return phase_ == Phase::Done; }

    /// W and the depth it was traced for, size of the frame; null where nothing is repaired.
    const gl::TextureStack* repaired() const { return repaired_ ? &*repaired_ : nullptr; }
    std::size_t pixels() const { return pixels_; }
    std::size_t bytes() const;

private:
    enum class Phase : std::uint8_t { Waiting, Asked, Tracing, Done };
    struct Pixel {
        glm::ivec2 at; ///< in the frame
        float depth;   ///< as the host's depth buffer has it
    };
    struct View {
        HostCamera camera;
        glm::ivec2 size;
        ClipConvention clip;
        bool operator==(const View&) const = default;
    };

    /// Draws where the cube maps leave a doubt, and starts reading it back.
    Status ask(const BackboneContext& context, const Frame& frame, const HostFramebuffer& host,
               const KeptTexels& kept, const std::vector<CubeMapProjector*>& projectors);
    /// Sorts the doubtful pixels into tiles.
    Status plan(const gl::Functions& gl, std::span<const std::uint8_t> depths);
    std::vector<TexelRequest> requests(const BackboneContext& context, float radius) const;
    void take(const TracedTexels& traced);

    gl::GLSLShader shader_;
    std::optional<View> view_;
    int framesAtRest_ = 0;
    Phase phase_ = Phase::Waiting;
    std::uint32_t generation_ = 0; ///< results of another are out of date
    gl::RenderToTexture2D doubt_;  ///< while it is read back
    gl::PixelReadback readback_;
    std::optional<gl::TextureStack> repaired_;
    std::vector<std::vector<Pixel>> tiles_; ///< doubtful pixels; empty once they are traced
    std::size_t pixels_ = 0;                ///< traced so far
};

} // namespace aolib
