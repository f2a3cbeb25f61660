#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "backbone/GeometryBuffer.h"
#include "gl/PixelReadback.h"

namespace aolib {

/// Counts, frames later and without a stall, which share of the geometry on screen is shaded
/// (thesis 4.6).
class Coverage {
public:
    /// Errors: ShaderError, OutOfMemory.
    static Result<Coverage> create(const BackboneContext& context);

    /// Starts counting this frame, unless all readbacks are still on their way.
    void count(const BackboneContext& context, const Frame& frame, const GeometryBuffer& geometry,
               const gl::RenderToTexture2D& visibility, std::uint64_t frameNumber);

    struct Answer {
        std::uint64_t frame;
        float shaded; ///< share of the geometry's pixels; 1 when there is no geometry
    };
    /// The newest answer that has arrived since the last call, if any.
    std::optional<Answer> poll();
    /// Forgets what was counted before now: the cube maps have changed.
    void restart();

private:
    static constexpr int kSize = 32; ///< pixels along the small target's edge

    struct Request {
        gl::PixelReadback readback;
        std::uint64_t frame = 0;
    };

    gl::GLSLShader shader_;
    gl::RenderToTexture2D target_;
    std::array<Request, 3> requests_;
};

} // namespace aolib
