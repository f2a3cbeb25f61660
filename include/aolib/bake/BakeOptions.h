#pragma once

#include <cstdint>
#include <vector>

#include <aolib/Options.h>

namespace aolib::bake {

/// Where light may come from. Since 0.1.
enum class Sky : std::uint8_t {
    Sphere, ///< everywhere
    Dome,   ///< above the horizon only; what faces down is dark
};

/// How rays are spread over the hemisphere.
enum class Sampling : std::uint8_t {
    Stratified, ///< Sobol's points, scrambled per receiver, with the density of the measure
    Rejection,  ///< uniform, from random points in a cube (GPU Gems, chapter 17.2)
};

/// What the share of open directions is a share of.
enum class Measure : std::uint8_t {
    Cosine,     ///< visibility W, 1/pi times the integral of V cos(theta)
    SolidAngle, ///< plain accessibility, 1/(2 pi) times the integral of V (GPU Gems, 17.2)
};

/// How the sums of a scattered map become visibility.
enum class Normalisation : std::uint8_t {
    Derived,   ///< by the number of directions and each texel's coverage
    Brightest, ///< the brightest texel is taken for fully open (McGraw and Sowers 2008)
};

/// What is done about texels that a chart covers in part, which get but a part of their points.
enum class SeamFix : std::uint8_t {
    Coverage, ///< each sum is divided by the share of the texel that charts cover
    Erosion,  ///< they are discarded and filled from within (McGraw and Sowers 2008)
};

/// Who adds scattered points to a map's texels. Both give the same but for rounding.
enum class PointSum : std::uint8_t {
    Auto,      ///< `Processor` where the context is Mesa's software rasteriser, else `Blending`
    Blending,  ///< points are drawn, and blended (McGraw and Sowers 2008)
    Processor, ///< the picture from each direction is read back
};

/// How values of vertices come about.
enum class VertexFit : std::uint8_t {
    Direct,       ///< at the vertex itself, about its normal
    TriangleMean, ///< at the triangles' centres, averaged over those about a vertex (17.2)
    LeastSquares, ///< the values that, interpolated, fit samples of the surface best (Kavan 2011)
};

/// Settings of baking by rays, on the CPU.
struct RayOptions {
    int rays = 256;      ///< per receiver, count, 1 to 2^20
    float radius = 0.0F; ///< reach of occluders, world units; 0 has no end, `falloff` is then Off
    Falloff falloff = Falloff::Step; ///< weight of an occluder by its distance
    Sampling sampling = Sampling::Stratified;
    Measure measure = Measure::Cosine;
    Sky sky = Sky::Sphere;
    bool sectors = false;   ///< also how open each sector of directions is: of vertices,
                            ///< `VertexFit::Direct` alone
    int threads = 0;        ///< workers, 0 takes one per core; does not change the result
    std::uint32_t seed = 0; ///< another seed, another noise
};

/// Settings of baking by scattered points, on the GPU.
struct ScatterOptions {
    int directions = 512;            ///< of light, count, 1 to 2^20
    float radius = 0.0F;             ///< as in RayOptions; at least a 512th of the scene's diagonal
    Falloff falloff = Falloff::Step; ///< weight of an occluder by its distance
    int rasterSize = 0;     ///< pixels along the picture from each direction, 64 to 16384; 0
                            ///< derives it from the texels that charts cover
    float pointSize = 0.5F; ///< texels along a point's edge, 0 (the nearest texel gets all) to 16
    bool stretchCorrection = true; ///< off: charts are taken to be stretched alike everywhere
    Normalisation normalisation = Normalisation::Derived;
    SeamFix seams = SeamFix::Coverage;
    PointSum sum = PointSum::Auto;
    Sky sky = Sky::Sphere;
    std::uint32_t seed = 0; ///< another seed, another noise
};

/// Settings of baking by shadow maps, on the GPU.
struct ShadowOptions {
    int directions = 512;            ///< of light, count, 1 to 2^20
    float radius = 0.0F;             ///< as in RayOptions; at least a 512th of the scene's diagonal
    Falloff falloff = Falloff::Step; ///< weight of an occluder by its distance
    int depthSize = 1024;            ///< texels along a depth map, 64 to 8192
    int mapsPerPass = 8; ///< depth maps read in one pass, count, 1 to 16; pairs of them where
                         ///< there is a radius
    float bias = 1.0F;   ///< how far receivers on a slope are lifted off it, texels of the depth
                         ///< map times the sine of the slope, 0 to 16
    Sky sky = Sky::Sphere;
    std::uint32_t seed = 0; ///< another seed, another noise
};

/// Settings of a map.
struct MapOptions {
    int width = 1024;  ///< texels, 1 to 16384
    int height = 1024; ///< texels, 1 to 16384
    int padding = 8;   ///< texels that each chart is grown by, 0 to 64
    /// Places across a texel that its rays or directions are shared out among, so that its value is
    /// the mean over it: 1 (its centre alone) to 64. Scattering gives that mean by itself.
    int texelSamples = 16;
    bool fill = true; ///< fill what no chart covers, too, so that mipmaps mix nothing foreign in
    /// Which texels of each map are wanted: not 0, as many as a map has, row 0 at the bottom; empty
    /// for all. The others are left like those that no chart covers. Rays and shadow maps take so
    /// much less time, scattering takes the same.
    std::vector<std::uint8_t> wanted = {};
};

/// Settings of vertices.
struct VertexOptions {
    VertexFit fit = VertexFit::Direct;
    float smoothness = 0.1F; ///< LeastSquares: weight of the differences along edges, 0 to 100
    float density = 4.0F;    ///< LeastSquares: samples per triangle on average, 1 to 256
};

} // namespace aolib::bake
