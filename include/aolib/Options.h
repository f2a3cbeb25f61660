#pragma once

#include <cstdint>

#include <aolib/StateTrust.h>

namespace aolib {

/// How the weight of an occluder falls with its distance L: `w(L) = 1 - rho(L)`, thesis eq. 3.2.
enum class Falloff : std::uint8_t {
    Step, ///< w = 1 for L < radius, else 0
    Exp,  ///< w = e^(-L / radius), thesis eq. 3.3 with tau = 1 / radius
    Off,  ///< w = 1 at every distance
};

/// Which strategy computes the ambient occlusion.
enum class Backbone : std::uint8_t {
    Cubemapped,  ///< computed once per cube map, kept, projected onto every later frame
    ScreenSpace, ///< the same estimator on the host's own view, every frame, nothing kept
};

/// How visibility is estimated from captured geometry.
enum class Estimator : std::uint8_t {
    HorizonSplit,     ///< thesis 4.3.1: the highest horizon over a number of directions
    LayeredIntervals, ///< slices through the cube's centre over layers of solid intervals
    RayTraced, ///< rays, on worker threads in the background, about the meshes' normals where they
               ///< have any; needs a texel tracer (AmbientOcclusion::setTexelTracer)
    Automatic, ///< RayTraced where it can be: there is a texel tracer, and all geometry is given as
               ///< triangles; else LayeredIntervals
};

/// How cube maps reach the host's picture. Both give the same pixels.
enum class ProjectionMethod : std::uint8_t {
    SinglePass, ///< all cube maps in one pass, blended into the picture at once
    PingPong,   ///< thesis 4.4: a pass per cube map, the best so far carried between two textures
};

/// What `aoDrawEnd()` shows in place of the host's picture. `Off` is the normal composite.
enum class DebugView : std::uint8_t {
    Off,
    AmbientOcclusion, ///< W in grey, background white
    Quality,          ///< quality factor of the chosen cube map: green good, red poor
    Faces,            ///< which cube face shades a pixel, one colour each, borders dark
    Coverage,         ///< the picture with unshaded pixels in red
    Edges,            ///< edges that the blur does not cross, in green
    Positions,        ///< world positions as colours, repeating once per radius
    Normals,          ///< world normals as colours, n * 0.5 + 0.5
};

/// Settings of `Estimator::HorizonSplit`.
struct HorizonSplitOptions {
    int directions = 16;   ///< slices about the normal, count, 1 to 128
    int steps = 16;        ///< samples per direction, count, 1 to 256
    float stepSize = 0.0F; ///< `Falloff::Step`: world units between samples; 0 derives radius /
                           ///< steps. Other falloffs share the samples out over all in reach

    bool operator==(const HorizonSplitOptions&) const = default;
};

/// Settings of `Estimator::LayeredIntervals`.
struct LayeredIntervalsOptions {
    int slices = 8;         ///< half turns about the axis to the cube's centre, count, 1 to 128
    int steps = 16;         ///< samples per slice and side, count, 1 to 256
    int layers = 8;         ///< most solid intervals kept along a ray, count, 1 to 8
    float thickness = 0.0F; ///< screen space and what a scene renderer draws: assumed depth of
                            ///< what is seen, world units; 0 = radius / 4

    bool operator==(const LayeredIntervalsOptions&) const = default;
};

/// Settings of `Estimator::RayTraced`.
struct RayTracedOptions {
    int rays = 256; ///< per texel when converged, count, 4 to 65536

    bool operator==(const RayTracedOptions&) const = default;
};

/// Settings of `Backbone::Cubemapped`.
struct CubeMapOptions {
    int faceSize = 512;    ///< texels along a face's edge, 16 to 4096
    int nearest = 10;      ///< cube maps projected per frame, nearest to the camera, 1 to 64
    bool place = true;     ///< place new cube maps at the camera where coverage falls short (an
                           ///< orthographic one: before what it sees)
    float coverage = 0.9F; ///< share of shaded pixels below which one is placed, 0 to 1
    ProjectionMethod projection = ProjectionMethod::SinglePass;
    /// MiB that cube maps may keep on the GPU, room for one at least; 0 = no limit. Those placed by
    /// coverage give way to newer ones, the least useful to recent views first.
    float memoryBudget = 512.0F;
    /// Use screen-space AO for pixels that no cube map covers yet, or ever (on a software
    /// rasteriser once half of the view is covered). Else they stay unshaded, W = 1.
    bool screenSpaceFallback = true;
    /// While a view is static, also compute its pixels by themselves, where texels are too coarse.
    /// With a tracer, pixels of low confidence are traced; without one, layered intervals compute
    /// all pixels of a perspective view. Horizon split keeps texels as they are.
    bool refineStaticViews = true;
    /// Project onto every second pixel of every second row and take that to the others by their
    /// depths: for many cube maps on weak devices. Pixels of a view at rest are whole all the same.
    bool halfResolution = false;
    bool outlines = false; ///< draw a small wire cube where each cube map stands

    /// Deprecated names of refineStaticViews and screenSpaceFallback: false switches them off, too.
    bool repair = true;
    bool fallback = true;
};

/// The edge-aware blur of what is noisy: horizon split, and all that is computed in screen space.
struct BlurOptions {
    bool enabled = true;
    int size = 7; ///< pixels along the filter's edge, odd, 1 to 15
};

/// Everything a host may set. An aggregate: take the defaults and change what matters.
struct Options {
    Backbone backbone = Backbone::Cubemapped;
    Estimator estimator = Estimator::Automatic;
    float radius = 0.0F; ///< world units; 0 derives 10% of the diagonal of the scene's bounding box
    Falloff falloff = Falloff::Step;
    float contrast = 1.0F; ///< alpha of thesis eq. 4.11, i = i_s ((1 - a) + a W); 0 to 1
    HorizonSplitOptions horizonSplit{};
    LayeredIntervalsOptions layeredIntervals{};
    RayTracedOptions rayTraced{};
    /// Milliseconds that computing cube maps may take in a frame: they get better over many. 0
    /// computes each at once, in the call that needs it.
    float frameBudget = 4.0F;
    CubeMapOptions cubeMaps{};
    BlurOptions blur{};
    DebugView debugView = DebugView::Off;
    bool debugGroups = true; ///< group each pass's commands for debuggers, where GL can
    StateTrust trust{};      ///< parts of the GL state that need not be restored
};

} // namespace aolib
