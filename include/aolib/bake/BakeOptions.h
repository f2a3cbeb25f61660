#pragma once

#include <cstdint>
#include <vector>

#include <aolib/Options.h>

namespace aolib::bake {

/// The directions that light comes from. Since 0.1.
enum class Sky : std::uint8_t {
    Sphere, ///< all
    Dome,   ///< those above the horizon; surfaces that face down are dark
};

/// How rays are spread over the hemisphere.
enum class Sampling : std::uint8_t {
    Stratified, ///< Sobol's points, scrambled per receiver, with the density of the measure
    Rejection,  ///< uniform, from random points in a cube (GPU Gems, chapter 17.2)
};

/// The measure of open directions.
enum class Measure : std::uint8_t {
    Cosine,     ///< visibility W, 1/pi times the integral of V cos(theta)
    SolidAngle, ///< plain accessibility, 1/(2 pi) times the integral of V (GPU Gems, 17.2)
};

/// How the sums of a scattered map become visibility.
enum class Normalisation : std::uint8_t {
    Derived,   ///< by the number of directions and each texel's coverage
    Brightest, ///< the brightest texel is taken for fully open (McGraw and Sowers 2008)
};

/// How scattering corrects texels that charts cover in part, and which get only part of their
/// points.
enum class SeamFix : std::uint8_t {
    Coverage, ///< divides each sum by the share of the texel that charts cover
    Erosion,  ///< discards these texels and fills them from within (McGraw and Sowers 2008)
};

/// How scattered points are added to a map's texels. Results differ by rounding only.
enum class PointSum : std::uint8_t {
    Auto,      ///< `Processor` if the context is Mesa's software rasteriser, else `Blending`
    Blending,  ///< the GPU draws and blends points (McGraw and Sowers 2008)
    Processor, ///< the CPU adds the pixels of each direction's picture, which is read back
};

/// How values of vertices are computed.
enum class VertexFit : std::uint8_t {
    Direct,       ///< at the vertex itself, about its normal
    TriangleMean, ///< mean over the triangles about a vertex of the values at their centres (17.2)
    LeastSquares, ///< values whose interpolation fits samples of the surface best (Kavan 2011)
};

/// Settings of baking by rays, on the CPU.
struct RayOptions {
    int rays = 256;      ///< per receiver, count, 1 to 2^20
    float radius = 0.0F; ///< reach of occluders, world units; 0 is infinite, `falloff` is then Off
    Falloff falloff = Falloff::Step; ///< weight of an occluder by its distance
    Sampling sampling = Sampling::Stratified;
    Measure measure = Measure::Cosine;
    Sky sky = Sky::Sphere;
    bool sectors = false;   ///< also bake the open share of each sector of directions; for vertices
                            ///< with `VertexFit::Direct` only
    int threads = 0;        ///< workers, 0 starts one per core; does not change the result
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
    bool stretchCorrection = true; ///< off: assumes that all charts are stretched equally
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
    int mapsPerPass = 8; ///< depth maps read in one pass, count, 1 to 16; pairs of maps if there
                         ///< is a radius
    float bias = 1.0F;   ///< distance by which receivers on a slope are lifted, texels of the depth
                         ///< map times the sine of the slope, 0 to 16
    Sky sky = Sky::Sphere;
    std::uint32_t seed = 0; ///< another seed, another noise
};

/// Settings of a map.
struct MapOptions {
    int width = 1024;  ///< texels, 1 to 16384
    int height = 1024; ///< texels, 1 to 16384
    int padding = 8;   ///< texels by which each chart is grown, 0 to 64
    /// Number of points across a texel among which its rays or directions are divided, 1 (the
    /// centre) to 64. The texel's value is the mean over them. Scattering computes that mean
    /// anyway.
    int texelSamples = 16;
    bool fill = true; ///< also fill texels outside charts, so that mipmaps mix in no other values
    /// A mask of the texels to bake, not 0 for those, row 0 at the bottom; empty for all. It has as
    /// many elements as a map has texels. Other texels are left as if no chart covered them. With
    /// rays and shadow maps fewer texels take less time; with scattering they take the same time.
    std::vector<std::uint8_t> wanted = {};
};

/// Settings of the values of vertices.
struct VertexOptions {
    VertexFit fit = VertexFit::Direct;
    float smoothness = 0.1F; ///< LeastSquares: weight of the differences along edges, 0 to 100
    float density = 4.0F;    ///< LeastSquares: samples per triangle on average, 1 to 256
};

} // namespace aolib::bake
