#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include <aolib/Options.h>
#include <aolib/Scene.h>

namespace aolib {

/// One cube map as it stands.
struct CubeMapInfo {
    CubeMapId id{};
    glm::vec3 position{};  ///< world units
    int faceSize = 0;      ///< texels along a face's edge
    int facesModelled = 0; ///< faces that hold geometry; the others cost no capture and no AO
    int layers = 0;        ///< layers of solid intervals that the last build captured
    std::size_t bytes = 0; ///< GPU memory kept
    std::size_t captureBytes = 0; ///< GPU memory that the last build took and gave back
    double buildMs = 0.0; ///< CPU time of the library's calls that computed it, since it last began
    double buildGpuMs = -1; ///< GPU time of the last build; -1 until the timer query has answered
};

/// What the latest frame did and cost, or the latest frame of one view. "The view" is whose frame
/// it was.
struct Statistics {
    std::uint64_t frame = 0;                    ///< frames ended so far, of all views
    Estimator estimator = Estimator::Automatic; ///< in force: the one that Automatic chose, too
    float coverage = -1.0F; ///< share of geometry pixels that are shaded; -1 until known
    /// The frame that `coverage` was counted in: a few back, up to a dozen for a view at rest.
    std::uint64_t coverageFrame = 0;
    /// Share of the view's pixels that show geometry, counted with `coverage`; -1 until known. 0
    /// for a depth buffer that was still clear at aoDrawEnd(), as in a hook that runs before the
    /// host draws: there is nothing to shade then, and `coverage` is 1. Backbone::Cubemapped alone.
    float geometryShare = -1.0F;
    int cubeMapsProjected = 0;         ///< in the latest frame
    int cubeMapsBuilt = 0;             ///< in the latest frame, placed or rebuilt
    std::uint64_t cubeMapsEvicted = 0; ///< so far, to keep the memory budget
    std::size_t pixelsRefined = 0;     ///< of a static view, computed by themselves
    /// How much is computed of what the view's cube maps need, 0 to 1, as far as is known: needs
    /// show on the way. 0 until a frame of what the view shows has been looked at, 1 once
    /// `converged` and only then. It only grows while neither the view nor the scene nor the
    /// options change, and begins anew when one does.
    float computed = 0.0F;
    bool converged = false; ///< nothing is left to compute for what the view shows
    /// Nothing is left to compute for any view that has been drawn of late: within the latest 64
    /// frames, or twice as many as there are views. One that nobody draws any more thus stops to
    /// count; removeView() has it stop at once.
    bool allConverged = false;
    int views = 0;             ///< that something is kept for
    double frameGpuMs = -1.0;  ///< GPU time of aolib's passes in an earlier frame; -1 until known
    std::size_t bytesKept = 0; ///< GPU memory of all cube maps
    std::size_t bytesBuilding = 0; ///< GPU memory held for cube maps on their way; given back
    std::size_t bytesFrame = 0;    ///< GPU memory of the per-frame targets
    std::size_t bytesScene = 0;    ///< GPU memory of the scene's triangles

    /// Deprecated name of pixelsRefined.
    std::size_t pixelsRepaired = 0;
};

/// Ambient occlusion of the latest frame, as it was blended: row 0 is the bottom row.
struct VisibilityImage {
    int width = 0;
    int height = 0;
    std::vector<float> visibility; ///< width * height values, W in [0,1]; background -1
};

/// What a cube map holds: six faces side by side, +X -X +Y -Y +Z -Z, row 0 at the bottom.
struct CubeMapImage {
    int faceSize = 0;
    glm::vec3 position{};
    std::vector<float> visibility; ///< 6 * faceSize * faceSize values, W in [0,1]
    std::vector<float> distance;   ///< along the texel's ray, world units; -1 where nothing was hit
};

} // namespace aolib
