#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include <aolib/Options.h>
#include <aolib/Scene.h>

namespace aolib {

/// The current state of one cube map.
struct CubeMapInfo {
    CubeMapId id{};
    glm::vec3 position{};         ///< world units
    int faceSize = 0;             ///< texels along a face's edge
    int facesModelled = 0;        ///< faces with geometry; the others need no capture and no AO
    int layers = 0;               ///< layers of solid intervals that the last build captured
    std::size_t bytes = 0;        ///< GPU memory kept, bytes
    std::size_t captureBytes = 0; ///< GPU memory, bytes, that the last build released at its end
    double buildMs = 0.0;         ///< CPU time of the calls of the last build, milliseconds
    double buildGpuMs = -1;       ///< GPU time of the last build, milliseconds; -1 until known
};

/// Results and costs of the latest frame, or of the latest frame of one view. "The view" is the
/// view of that frame.
struct Statistics {
    std::uint64_t frame = 0;                    ///< frames ended so far, of all views
    Estimator estimator = Estimator::Automatic; ///< the effective one: Automatic is resolved
    float coverage = -1.0F; ///< share of geometry pixels that are shaded; -1 until known
    /// The frame that `coverage` was counted in: a few frames ago, up to a dozen for a static view.
    std::uint64_t coverageFrame = 0;
    /// Share of the view's pixels that show geometry, counted with `coverage`; -1 until known.
    /// The share is 0 if the depth buffer is still clear at aoDrawEnd(), for instance in a hook
    /// that runs before the host draws; `coverage` is then 1. Backbone::Cubemapped only.
    float geometryShare = -1.0F;
    int cubeMapsProjected = 0;         ///< cube maps projected in the latest frame
    int cubeMapsBuilt = 0;             ///< cube maps placed or rebuilt in the latest frame
    std::uint64_t cubeMapsEvicted = 0; ///< so far, to keep the memory budget
    std::size_t pixelsRefined = 0;     ///< pixels of a static view that were computed singly
    /// Computed share of the work known for the view's cube maps, 0 to 1. More work may be found
    /// while cube maps are being computed.
    /// 0 until the feedback of a frame of the view is read; 1 if and only if `converged`.
    /// Never decreases while view, scene and options are unchanged; restarts when one changes.
    float computed = 0.0F;
    bool converged = false; ///< nothing is left to compute for the view
    /// Nothing is left to compute for any recent view. A view is recent for 64 frames after it was
    /// drawn, or for two frames per view if that is longer. removeView() ends this at once.
    bool allConverged = false;
    int views = 0;             ///< views that data is kept for
    double frameGpuMs = -1.0;  ///< GPU time of aolib's passes in an earlier frame; -1 until known
    std::size_t bytesKept = 0; ///< GPU memory of all cube maps, bytes
    std::size_t bytesBuilding =
        0;                      ///< GPU memory for cube maps being computed, bytes; released after
    std::size_t bytesFrame = 0; ///< GPU memory of the per-frame targets, bytes
    std::size_t bytesScene = 0; ///< GPU memory of the scene's triangles, bytes

    /// Deprecated name of pixelsRefined.
    std::size_t pixelsRepaired = 0;
};

/// Ambient occlusion of a frame, as blended into its picture; row 0 is the bottom row.
struct VisibilityImage {
    int width = 0;
    int height = 0;
    std::vector<float> visibility; ///< width * height values, W in [0,1]; background -1
};

/// The texels of a cube map: six faces side by side, +X -X +Y -Y +Z -Z, row 0 at the bottom.
struct CubeMapImage {
    int faceSize = 0;
    glm::vec3 position{};
    std::vector<float> visibility; ///< 6 * faceSize * faceSize values, W in [0,1]
    std::vector<float> distance; ///< along the texel's ray, world units; -1 if the ray hits nothing
};

} // namespace aolib
