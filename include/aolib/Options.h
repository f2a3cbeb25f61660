#pragma once

#include <cstdint>

#include <aolib/StateTrust.h>

namespace aolib {

/// The weight w of an occluder by its distance L: `w(L) = 1 - rho(L)`, thesis eq. 3.2.
enum class Falloff : std::uint8_t {
    Step, ///< w = 1 for L < radius, else 0
    Exp,  ///< w = e^(-L / radius), thesis eq. 3.3 with tau = 1 / radius
    Off,  ///< w = 1 at every distance
};

/// The strategy that computes the ambient occlusion.
enum class Backbone : std::uint8_t {
    Cubemapped,  ///< computes each cube map once and projects it onto every later frame
    ScreenSpace, ///< runs the estimator on the host's view in every frame and keeps nothing
};

/// The method that estimates visibility.
enum class Estimator : std::uint8_t {
    HorizonSplit,     ///< thesis 4.3.1: the highest horizon over a number of directions
    LayeredIntervals, ///< slices through the cube's centre over layers of solid intervals
    /// Rays about the meshes' normals, or geometric normals of meshes without, traced on worker
    /// threads. Needs a texel tracer (AmbientOcclusion::setTexelTracer).
    RayTraced,
    /// RayTraced if a texel tracer is set and all geometry is given as triangles; else
    /// LayeredIntervals.
    Automatic,
};

/// The passes that project cube maps onto the host's picture. Both give the same pixels.
enum class ProjectionMethod : std::uint8_t {
    SinglePass, ///< all cube maps in one pass, blended into the picture at once
    PingPong,   ///< thesis 4.4: one pass per cube map; two textures hold the best value by turns
};

/// The picture that `aoDrawEnd()` shows. `Off` is the host's picture with ambient occlusion.
enum class DebugView : std::uint8_t {
    Off,
    AmbientOcclusion, ///< W in grey, background white
    Quality,          ///< quality factor of the chosen cube map: green good, red poor
    Faces,            ///< the cube face that shades a pixel, one colour each, borders dark
    Coverage,         ///< the picture with unshaded pixels in red
    Edges,            ///< edges that the blur does not cross, in green
    Positions,        ///< world positions as colours, repeating once per radius
    Normals,          ///< world normals as colours, n * 0.5 + 0.5
};

/// Settings of `Estimator::HorizonSplit`.
struct HorizonSplitOptions {
    int directions = 16; ///< slices about the normal, count, 1 to 128
    int steps = 16;      ///< samples per direction, count, 1 to 256
    /// World units between samples of `Falloff::Step`; 0 = radius / steps. Other falloffs spread
    /// the samples over everything within reach.
    float stepSize = 0.0F;

    bool operator==(const HorizonSplitOptions&) const = default;
};

/// Settings of `Estimator::LayeredIntervals`.
struct LayeredIntervalsOptions {
    int slices = 8; ///< half turns about the axis to the cube's centre, count, 1 to 128
    int steps = 16; ///< samples per slice and side, count, 1 to 256
    int layers = 8; ///< most solid intervals kept along a ray, count, 1 to 8
    /// Assumed thickness of visible surfaces, world units; 0 = radius / 4. Used in screen space
    /// and with a scene renderer.
    float thickness = 0.0F;

    bool operator==(const LayeredIntervalsOptions&) const = default;
};

/// Settings of `Estimator::RayTraced`.
struct RayTracedOptions {
    int rays = 256; ///< rays per converged texel, count, 4 to 65536

    bool operator==(const RayTracedOptions&) const = default;
};

/// Settings of `Backbone::Cubemapped`.
struct CubeMapOptions {
    int faceSize = 512; ///< texels along a face's edge, 16 to 4096
    int nearest = 10;   ///< cube maps projected per frame, nearest to the camera, 1 to 64
    /// Place a new cube map at the camera when the coverage of a view is below `coverage`. For an
    /// orthographic camera: in front of the visible geometry.
    bool place = true;
    float coverage = 0.9F; ///< share of shaded pixels below which a cube map is placed, 0 to 1
    ProjectionMethod projection = ProjectionMethod::SinglePass;
    /// GPU memory for cube maps, MiB; at least that of one cube map; 0 = no limit. At the limit, a
    /// new cube map evicts one that was placed by coverage: the least useful to recent views.
    float memoryBudget = 512.0F;
    /// Use screen-space AO for pixels that no cube map covers. If off, these pixels stay unshaded,
    /// W = 1. On a software rasteriser the fallback starts once half of the view is covered.
    bool screenSpaceFallback = true;
    /// While a view is static, also compute single pixels where texels are too coarse.
    /// With a tracer, pixels of low confidence are traced. Without one, layered intervals compute
    /// all pixels of a perspective view. Horizon split computes no single pixels.
    bool refineStaticViews = true;
    /// Project onto every second pixel of every second row, and upsample to the others by depth:
    /// for many cube maps on weak devices. A static view still reaches full resolution.
    bool halfResolution = false;
    bool outlines = false; ///< draw a small wire cube where each cube map stands

    /// Deprecated names of refineStaticViews and screenSpaceFallback. False in either field of a
    /// pair switches the feature off.
    bool repair = true;
    bool fallback = true;
};

/// Settings of the edge-aware blur, which denoises horizon split and all screen-space AO.
struct BlurOptions {
    bool enabled = true;
    int size = 7; ///< pixels along the filter's edge, odd, 1 to 15
};

/// All settings of an instance. The defaults suit most hosts.
struct Options {
    Backbone backbone = Backbone::Cubemapped;
    Estimator estimator = Estimator::Automatic;
    float radius = 0.0F; ///< world units; 0 = 10% of the diagonal of the scene's bounding box
    Falloff falloff = Falloff::Step;
    float contrast = 1.0F; ///< alpha of thesis eq. 4.11, i = i_s ((1 - a) + a W); 0 to 1
    HorizonSplitOptions horizonSplit{};
    LayeredIntervalsOptions layeredIntervals{};
    RayTracedOptions rayTraced{};
    /// Milliseconds per frame for computing cube maps, which are refined over many frames. 0
    /// computes each cube map completely in the call that needs it.
    float frameBudget = 4.0F;
    CubeMapOptions cubeMaps{};
    BlurOptions blur{};
    DebugView debugView = DebugView::Off;
    bool debugGroups = true; ///< group each pass's commands for debuggers, where GL can
    StateTrust trust{};      ///< parts of the GL state that need not be restored
};

} // namespace aolib
