#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "backbone/passes/Projection.h"
#include "gl/PixelReadback.h"

namespace aolib {

/// What a view showed in one of its frames, sampled sparsely.
struct FeedbackResult {
    std::uint64_t frame = 0;
    float shaded = -1.0F;          ///< share of the surfaces; 1 when there are none; -1 unknown
    float surfaces = -1.0F;        ///< share of the samples that show one; -1 unknown
    glm::dvec3 eye{0.0};           ///< of that frame, world units
    std::vector<glm::vec3> points; ///< of the surfaces, relative to the eye, world axes
    std::vector<bool> shades;      ///< by point: whether a cube map does
    std::vector<float> footprints; ///< what a pixel covers there, square on, world units
    /// By point: the cube map that looks its way, but sees another surface before it; 0 where
    /// some cube map covers it or none looks that way.
    std::vector<CubeMapId> hiddenFrom;
    /// Share of the surfaces that a cube map shades, as the best of all; none for those that
    /// are best nowhere.
    std::map<CubeMapId, float> best;
    std::vector<CubeMapId> projected; ///< the cube maps that it saw
};

/// The feedback of one view that is still on the GPU.
class PendingFeedback {
public:
    /// The newest result that has arrived since the last call, if any.
    std::optional<FeedbackResult> poll();
    /// Drops what was sampled before now: the cube maps have changed.
    void restart();

private:
    friend class FeedbackPass;
    struct Request {
        gl::PixelReadback readback;
        std::uint64_t frame = 0;
        glm::dvec3 eye{0.0};
        std::vector<CubeMapId> cubeMaps; ///< by the numbers that samples name them by
    };
    static FeedbackResult evaluate(const Request& request, std::span<const std::uint8_t> pixels);

    std::vector<Request> requests_; ///< empty before the first pass
};

/// The feedback pass of the sparse texture that cube maps are: samples what the host's view shows,
/// which share of it is shaded (thesis 4.6), and where the surfaces are whose tiles are needed. Its
/// results arrive frames later, without a stall.
class FeedbackPass {
public:
    /// Errors: ShaderError, OutOfMemory.
    static Result<FeedbackPass> create(const BackboneContext& context);

    /// Starts sampling a frame of a view, unless all its readbacks are pending.
    /// Errors: OutOfMemory.
    AoStatus issue(const FrameContext& context, const ProjectedCubeMaps& cubeMaps,
                   std::uint64_t frameNumber, PendingFeedback& into);

private:
    static constexpr int kSize = 128;       ///< samples along the small target's edge
    static constexpr std::size_t kMost = 3; ///< pending for a view

    AoStatus makeReadbacks(const BackboneContext& context, PendingFeedback& of) const;

    gl::GLSLShader shader_;
    gl::RenderToTexture2D target_;
};

} // namespace aolib
