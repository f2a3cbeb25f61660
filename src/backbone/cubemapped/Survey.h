#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "backbone/cubemapped/Projection.h"
#include "gl/PixelReadback.h"

namespace aolib {

/// Samples, frames later and without a stall, what the host's view shows: which share of it is
/// shaded (thesis 4.6), and where the surfaces are that cube maps have to know.
class Survey {
public:
    /// Errors: ShaderError, OutOfMemory.
    static Result<Survey> create(const BackboneContext& context);

    /// Starts sampling this frame, unless all readbacks are still on their way.
    void take(const BackboneContext& context, const Frame& frame, const HostFramebuffer& host,
              const KeptTexels& kept, const std::vector<CubeMapProjector*>& projectors,
              std::uint64_t frameNumber);

    struct Answer {
        std::uint64_t frame = 0;
        float shaded = 1.0F;           ///< share of the surfaces; 1 when there are none
        glm::dvec3 eye{0.0};           ///< of that frame, world units
        std::vector<glm::vec3> points; ///< of the surfaces, relative to the eye, world axes
        std::vector<bool> shades;      ///< by point: whether a cube map does
        std::vector<float> footprints; ///< what a pixel covers there, square on, world units
        /// By point: the cube map that might know the surface, but for another before it; 0 where
        /// some cube map knows it or none looks that way.
        std::vector<CubeMapId> hiddenFrom;
        /// Share of the surfaces that a cube map shades, as the best of all; none for those that
        /// are best nowhere.
        std::map<CubeMapId, float> best;
        std::vector<CubeMapId> projected; ///< the cube maps that it saw
    };
    /// The newest answer that has arrived since the last call, if any.
    std::optional<Answer> poll();
    /// Forgets what was sampled before now: the cube maps have changed.
    void restart();

private:
    static constexpr int kSize = 128; ///< samples along the small target's edge

    struct Request {
        gl::PixelReadback readback;
        std::uint64_t frame = 0;
        glm::dvec3 eye{0.0};
        std::vector<CubeMapId> cubeMaps; ///< by the numbers that samples name them by
    };
    static Answer evaluate(const Request& request, std::span<const std::uint8_t> pixels);

    gl::GLSLShader shader_;
    gl::RenderToTexture2D target_;
    std::array<Request, 3> requests_;
};

} // namespace aolib
