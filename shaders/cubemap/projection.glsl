// What cube maps know of a surface point (thesis 4.4): the best quality factor wins, and close calls
// are blended, so that neither a border between two cube maps nor a new one shows as a step.
#include "shared/cube_faces.h"
#include "shared/distance_code.h"
#include "shared/quality.h"

uniform sampler2DArray uCubeVisibility; // a layer per face that is kept
uniform sampler2DArray uCubeDepth;      // coded depth along the face's axis; 0 where nothing is known
uniform int uFaceSize;                  // texels
// Tiles in which surfaces end are kept finer, as blocks of their own: read where AO_DETAIL is defined.
// (A software rasteriser runs every branch: what a uniform switches off would cost all the same.)
uniform sampler2DArray uPages; // a layer per face, a texel per tile: 0, or 1 + the number of its block
uniform sampler2DArray uDetailVisibility;
uniform sampler2DArray uDetailDepth;
// Per cube map: from its centre to the eye (world units), and what is added to log2 of its quality.
uniform vec4 uCubeToEye[64];
uniform vec4 uDepthCode[64]; // nearest depth, log2(farthest / nearest), two unused
// Layers of the six faces, two to a number: +X -X, +Y -Y, +Z -Z; kNoLayer where none is kept.
uniform ivec4 uFaceLayers[64];

const int kNoLayer = 0xFFFF;
const int kTile = 32;        // texels along a tile's edge
const int kDetailScale = 4;  // texels of detail along a texel
const int kBlock = kTile * kDetailScale;
const int kBlocksPerRow = 4; // of a layer of the detail textures
// A texel belongs to the pixel's surface when it lies on the pixel's tangent plane to within this
// many texel footprints (more at grazing angles, where a footprint on the surface is longer).
const float kPlaneFootprints = 0.5;
const float kSteepest = 0.2; // cosine below which the tolerance grows no more
// Weights go with this power of the quality factor; what is below the best by more than the margin
// (in log2 of quality) counts for nothing and is not looked up.
const float kSharpness = 4.0;
const float kMargin = 2.0;
// What is known only from nearby counts for less than all that is known from the surface itself.
const float kGuess = -1000.0;
// Sum of weights, 2^-(distance in footprints)^2, from which texels are near enough.
const float kLeastWeight = 0.002;
const float kUnknown = -1.0e5; // log2 of quality where no cube map knows the surface
// Texels about a point that differ by more than this in visibility leave it in doubt.
const float kDoubtfulSpread = 0.05;

struct Projected {
    float sum;     // of visibility, weighted
    float weights; // relative to the best quality
    float quality; // log2, of the best
    int face;      // of the best
    vec2 uv;       // on that face
    int guess;     // the best of those that see its direction but do not know the surface
    float guessQuality;
    bool doubt; // the best does not quite tell the surface's visibility
};

Projected nothingProjected() {
    return Projected(0.0, 0.0, kUnknown, 0, vec2(0.0), -1, kUnknown, true);
}

int faceLayer(int cube, int face) {
    return (uFaceLayers[cube][face >> 1] >> (16 * (face & 1))) & 0xFFFF;
}

// Four texels of a face: the one at `corner` and those right of, above and diagonal to it.
struct Quad {
    vec4 visibility;
    vec4 depth; // along the face's axis; garbage where nothing is known
    vec4 known; // 1 or 0
    vec4 s;     // their rays are (s, t, 1) in the face's axes
    vec4 t;
};

// The texels of a grid: of a face as a whole, or of the detail of one of its tiles.
struct Grid {
    bool detail;
    int layer;
    ivec2 origin; // of the grid's texel (0, 0) in its texture
    ivec2 offset; // of the grid's texel (0, 0) on the face, in texels of this fineness
    ivec2 extent; // texels across and up
    float size;   // texels of this fineness along the face's edge
};

#ifdef GL_ARB_texture_gather
#define FOUR(sampler) textureGather(sampler, middle).wzxy
#else
#define FOUR(sampler)                                                                                 \
    vec4(texelFetch(sampler, at, 0).r, texelFetch(sampler, at + ivec3(1, 0, 0), 0).r,                 \
         texelFetch(sampler, at + ivec3(0, 1, 0), 0).r, texelFetch(sampler, at + ivec3(1, 1, 0), 0).r)
#endif

Quad quadAt(Grid grid, ivec2 corner, vec2 code) {
    Quad quad;
    vec4 codes;
    ivec3 at = ivec3(grid.origin + corner, grid.layer);
#ifdef AO_DETAIL
    if (grid.detail) {
        vec3 middle = vec3((vec2(at.xy) + 1.0) / float(kBlocksPerRow * kBlock), float(at.z));
        codes = FOUR(uDetailDepth);
        quad.visibility = FOUR(uDetailVisibility);
    } else
#endif
    {
        vec3 middle = vec3((vec2(at.xy) + 1.0) / float(uFaceSize), float(at.z));
        codes = FOUR(uCubeDepth);
        quad.visibility = FOUR(uCubeVisibility);
    }
    quad.known = vec4(greaterThan(codes, vec4(0.0)));
    quad.depth = code.x * exp2((codes * 65535.0 - 1.0) / 65534.0 * code.y);
    float step = 2.0 / grid.size;
    vec2 ray = (vec2(grid.offset + corner) + 0.5) * step - 1.0;
    quad.s = ray.x + vec4(0.0, step, 0.0, step);
    quad.t = ray.y + vec4(0.0, 0.0, step, step);
    return quad;
}

// Visibility of p by the four texels about it that lie on its surface; negative if there is none.
// All in the face's axes; `at` in texels from the middle of the grid's first.
// @param doubt  whether not all four do, or they differ
float lookUp(vec3 p, vec3 normal, Grid grid, vec2 at, vec2 code, float tolerance, out bool doubt) {
    vec2 corner = clamp(floor(at), vec2(0.0), vec2(grid.extent - 2));
    vec2 f = clamp(at - corner, 0.0, 1.0);
    Quad quad = quadAt(grid, ivec2(corner), code);
    // A ray's distance from the tangent plane is affine in s and t.
    vec4 off = abs(quad.depth * (normal.x * quad.s + normal.y * quad.t + normal.z) - dot(normal, p));
    // Never quite zero: a lone texel in the far corner is better than none.
    vec4 weights = vec4((1.0 - f.x) * (1.0 - f.y), f.x * (1.0 - f.y), (1.0 - f.x) * f.y, f.x * f.y) +
                   1.0e-3;
    vec4 belongs = vec4(lessThanEqual(off, vec4(tolerance))) * quad.known;
    weights *= belongs;
    float sum = dot(weights, vec4(1.0));
    vec2 least = min(quad.visibility.xy, quad.visibility.zw);
    vec2 most = max(quad.visibility.xy, quad.visibility.zw);
    doubt = dot(belongs, vec4(1.0)) < 3.5 ||
            max(most.x, most.y) - min(least.x, least.y) > kDoubtfulSpread;
    return sum > 0.0 ? dot(weights, quad.visibility) / sum : -1.0;
}

// The same where none of the four is on the surface, as at edges that are finer than a texel: by the
// sixteen about it, whichever are near in space.
float lookAbout(vec3 p, Grid grid, vec2 at, vec2 code, float footprint) {
    ivec2 first = ivec2(floor(at)) - 1;
    float sum = 0.0;
    float weights = 0.0;
    float scale = -1.0 / (footprint * footprint);
    for (int i = 0; i < 4; ++i) {
        ivec2 corner = clamp(first + 2 * ivec2(i & 1, i >> 1), ivec2(0), grid.extent - 2);
        Quad quad = quadAt(grid, corner, code);
        vec4 x = quad.depth * quad.s - p.x;
        vec4 y = quad.depth * quad.t - p.y;
        vec4 z = quad.depth - p.z;
        vec4 distance2 = x * x + y * y + z * z;
        vec4 weight = exp2(max(scale * distance2, -100.0)) * quad.known;
        sum += dot(weight, quad.visibility);
        weights += dot(weight, vec4(1.0));
    }
    return weights > kLeastWeight ? sum / weights : -1.0;
}

// Adds what one cube map knows of a point.
// @param eyeTo       from the eye to the point, world axes
// @param resolution  how much the point's depth may be wrong, world units
void project(int cube, vec3 eyeTo, vec3 normal, float resolution, inout Projected best) {
    vec3 p = uCubeToEye[cube].xyz + eyeTo;
    float facing = -dot(normal, p);
    if (!(facing > 0.0)) {
        return; // the cube map sees the other side, if any
    }
    float distance2 = dot(p, p);
    vec3 a = abs(p);
    float depth = max(a.x, max(a.y, a.z));
    float quality = logQuality(distance2, depth, facing) + uCubeToEye[cube].w;
    if (quality < best.quality - kMargin) {
        return;
    }
    int face = faceOf(p);
    int layer = faceLayer(cube, face);
    if (layer == kNoLayer) {
        return;
    }
    float cosDelta = facing * inversesqrt(distance2);
    float footprint = 2.0 * depth / float(uFaceSize);
    float tolerance = kPlaneFootprints * footprint / max(cosDelta, kSteepest) + resolution;
    vec3 inFace = toFace(face, p);
    vec3 normalInFace = toFace(face, normal);
    vec2 uv = inFace.xy / inFace.z * 0.5 + 0.5;
    vec2 at = uv * float(uFaceSize);
    vec2 code = uDepthCode[cube].xy;
    // Seen from less than half a texel above it, a surface may well lie between the texels' rays.
    float resolved = cosDelta * float(uFaceSize);
    float visibility = -1.0;
    bool doubt = false;
#ifdef AO_DETAIL
    ivec2 tile = min(ivec2(at), uFaceSize - 1) / kTile;
    int page = int(texelFetch(uPages, ivec3(tile, layer), 0).r * 65535.0 + 0.5);
    if (page > 0 && resolved * float(kDetailScale) >= 1.0) {
        int block = page - 1;
        int inLayer = block % (kBlocksPerRow * kBlocksPerRow);
        Grid grid = Grid(true, block / (kBlocksPerRow * kBlocksPerRow),
                         kBlock * ivec2(inLayer % kBlocksPerRow, inLayer / kBlocksPerRow),
                         tile * kBlock, min(ivec2(kBlock), kDetailScale * uFaceSize - tile * kBlock),
                         float(kDetailScale * uFaceSize));
        vec2 inBlock = at * float(kDetailScale) - vec2(grid.offset) - 0.5;
        visibility = lookUp(inFace, normalInFace, grid, inBlock, code,
                            (tolerance - resolution) / float(kDetailScale) + resolution, doubt);
    }
#endif
    if (visibility < 0.0) {
        Grid grid = Grid(false, layer, ivec2(0), ivec2(0), ivec2(uFaceSize), float(uFaceSize));
        if (resolved >= 1.0) {
            bool coarse;
            visibility = lookUp(inFace, normalInFace, grid, at - 0.5, code, tolerance, coarse);
            doubt = doubt || coarse;
        }
    }
    if (visibility < 0.0) {
        if (quality > best.guessQuality) {
            best.guessQuality = quality;
            best.guess = cube;
        }
        return;
    }
    if (quality > best.quality) {
        float fade = exp2(max(kSharpness * (best.quality - quality), -100.0));
        best = Projected(best.sum * fade + visibility, best.weights * fade + 1.0, quality, face, uv,
                         best.guess, best.guessQuality, doubt);
    } else {
        float weight = exp2(kSharpness * (quality - best.quality));
        best.sum += weight * visibility;
        best.weights += weight;
    }
}

// Notes a cube map that sees a point's direction as one to guess by: what project() does in passing,
// for those of earlier passes.
void consider(int cube, vec3 eyeTo, vec3 normal, inout Projected best) {
    vec3 p = uCubeToEye[cube].xyz + eyeTo;
    float facing = -dot(normal, p);
    vec3 a = abs(p);
    float quality = logQuality(dot(p, p), max(a.x, max(a.y, a.z)), facing) + uCubeToEye[cube].w;
    if (facing > 0.0 && faceLayer(cube, faceOf(p)) != kNoLayer && quality > best.guessQuality) {
        best.guessQuality = quality;
        best.guess = cube;
    }
}

// After all cube maps: where none knows the surface, what the best of them knows nearby. Apart from
// project(), because a software rasteriser runs every branch, for each cube map again.
void guess(vec3 eyeTo, inout Projected best) {
    if (best.weights > 0.0 || best.guess < 0) {
        return;
    }
    int cube = best.guess;
    vec3 p = uCubeToEye[cube].xyz + eyeTo;
    int face = faceOf(p);
    vec3 inFace = toFace(face, p);
    vec2 uv = inFace.xy / inFace.z * 0.5 + 0.5;
    Grid grid = Grid(false, faceLayer(cube, face), ivec2(0), ivec2(0), ivec2(uFaceSize),
                     float(uFaceSize));
    float visibility = lookAbout(inFace, grid, uv * float(uFaceSize) - 0.5, uDepthCode[cube].xy,
                                 2.0 * inFace.z / float(uFaceSize));
    if (visibility >= 0.0) {
        best.sum = visibility;
        best.weights = 1.0;
        best.quality = best.guessQuality + kGuess;
        best.doubt = true;
        best.face = face;
        best.uv = uv;
    }
}
