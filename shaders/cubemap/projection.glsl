// What cube maps know of a surface point (thesis 4.4): the best quality factor wins, and close calls
// are blended, so that neither a border between two cube maps nor a new one shows as a step.
#include "shared/cube_faces.h"
#include "shared/distance_code.h"
#include "shared/quality.h"

uniform sampler2DArray uCubeVisibility; // a layer per face that is kept
uniform sampler2DArray uCubeDepth;      // coded depth along the face's axis; 0 where nothing is known
uniform int uFaceSize;                  // texels
// Pages, which tiles have beside their texels: finer ones where surfaces end, or as fine ones of the
// surfaces behind. Read where AO_PAGES is defined. (A software rasteriser runs every branch: what a
// uniform switches off would cost all the same.) They lie in layers of the same textures.
uniform sampler2DArray uPages; // a layer per face, a texel per tile: 1 + layer of its page, and where
                               // in the layer, x + 256 y in pages; 0 where it has none
uniform float uReach;           // of occluders, world units
uniform int uPageScale;       // texels of pages along a texel; 1: they are of the surfaces behind
// Per cube map: from its centre to the eye (world units), and what its quality is multiplied by.
uniform vec4 uCubeToEye[64];
uniform vec4 uDepthCode[64]; // what codes of depth span, two unused
// Layers of the six faces, two to a number: +X -X, +Y -Y, +Z -Z; kNoLayer where none is kept.
uniform ivec4 uFaceLayers[64];

const int kNoLayer = 0xFFFF;
const int kTile = 32; // texels along a tile's edge
// A texel belongs to the pixel's surface when it lies on the pixel's tangent plane to within this
// many texel footprints (more at grazing angles, where a footprint on the surface is longer).
const float kPlaneFootprints = 0.5;
const float kSteepest = 0.2; // cosine below which the tolerance grows no more
// Seen at a grazing angle, what stands on a surface lies near its plane, too. It hides the surface, but for
// texels of surfaces behind others: of these none may be farther from the pixel along the face's axis
// than this many tolerances, 1.5 times the length of a texel on the surface.
const float kBehindTolerances = 3.0;
const float kAnywhere = 1.0e30;
// Weights go with the fourth power of the quality factor; what is below this share of the best counts for
// nothing.
const float kLeastShare = 0.25;
// Visibility changes within the reach of occluders: texels that are longer on the surface know
// nothing of it, but where pixels are about as long. Cube maps that look along a surface from far away
// have such.
const float kLongestOfReach = 1.0;
const float kLongestOfPixel = 32.0;
const float kMostGrazing = 0.01; // cosine to the viewer below which pixels count as no longer
// Sum of weights, 2^-(distance in footprints)^2, from which texels are near enough.
const float kLeastWeight = 0.002;
// Texels about a point that differ by more than this in visibility leave it in lowConfidence.
const float kDoubtfulSpread = 0.03;

struct Projected {
    float sum;     // of visibility, weighted
    float weights; // relative to the best quality
    float quality; // of the best that knows the surface; 0 where none does
    int cube;      // the best
    int face;      // of the best
    vec2 uv;       // on that face
    int fallbackCube; // the best of those that look its way but hold no texel of the surface
    float fallbackQuality;
    bool lowConfidence; // its texels about the surface differ, or some are of other surfaces
};

Projected nothingProjected() {
    return Projected(0.0, 0.0, 0.0, 0, 0, vec2(0.0), -1, 0.0, true);
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

// The texels of a grid: of a face as a whole, or of a page of one of its tiles.
struct Grid {
    int layer;
    ivec2 origin; // of the grid's texel (0, 0) in its layer
    ivec2 offset; // of the grid's texel (0, 0) on the face, in texels of this fineness
    ivec2 extent; // texels across and up
    int scale;    // texels of this fineness along a texel of the face
};

Grid wholeFace(int layer) {
    return Grid(layer, ivec2(0), ivec2(0), ivec2(uFaceSize), 1);
}

#ifdef GL_ARB_texture_gather
#define FOUR(sampler) textureGather(sampler, middle).wzxy
#else
#define FOUR(sampler)                                                                                 \
    vec4(texelFetch(sampler, at, 0).r, texelFetch(sampler, at + ivec3(1, 0, 0), 0).r,                 \
         texelFetch(sampler, at + ivec3(0, 1, 0), 0).r, texelFetch(sampler, at + ivec3(1, 1, 0), 0).r)
#endif

Quad quadAt(Grid grid, ivec2 corner, vec2 code) {
    Quad quad;
    ivec3 at = ivec3(grid.origin + corner, grid.layer);
    vec3 middle = vec3((vec2(at.xy) + 1.0) / float(uFaceSize), float(at.z));
    vec4 codes = FOUR(uCubeDepth);
    quad.visibility = FOUR(uCubeVisibility);
    quad.known = vec4(greaterThan(codes, vec4(0.0)));
    quad.depth = intBitsToFloat(ivec4(code.x + (codes * 65535.0 - 1.0) / 65534.0 * code.y));
    float step = 2.0 / float(grid.scale * uFaceSize);
    vec2 ray = (vec2(grid.offset + corner) + 0.5) * step - 1.0;
    quad.s = ray.x + vec4(0.0, step, 0.0, step);
    quad.t = ray.y + vec4(0.0, 0.0, step, step);
    return quad;
}

// Visibility of p by the four texels about it that lie on its surface; negative if there is none.
// All in the face's axes; `at` in texels from the middle of the grid's first.
// @param tolerance  how far from p's tangent plane they may lie
// @param apart      how far from p along the face's axis
// @param lowConfidence      whether not all four do, or they differ
float sampleBilinear(vec3 p, vec3 normal, Grid grid, vec2 at, vec2 code, float tolerance, float apart,
             out bool lowConfidence) {
    vec2 corner = clamp(floor(at), vec2(0.0), vec2(grid.extent - 2));
    vec2 f = clamp(at - corner, 0.0, 1.0);
    Quad quad = quadAt(grid, ivec2(corner), code);
    // A ray's distance from the tangent plane is affine in s and t.
    vec4 off = abs(quad.depth * (normal.x * quad.s + normal.y * quad.t + normal.z) - dot(normal, p));
    // Never quite zero: a lone texel in the far corner is better than none.
    vec4 weights = vec4((1.0 - f.x) * (1.0 - f.y), f.x * (1.0 - f.y), (1.0 - f.x) * f.y, f.x * f.y) +
                   1.0e-3;
    vec4 belongs = vec4(lessThanEqual(off, vec4(tolerance))) * quad.known *
                   vec4(lessThanEqual(abs(quad.depth - p.z), vec4(apart)));
    weights *= belongs;
    float sum = dot(weights, vec4(1.0));
    vec2 least = min(quad.visibility.xy, quad.visibility.zw);
    vec2 most = max(quad.visibility.xy, quad.visibility.zw);
    lowConfidence = dot(belongs, vec4(1.0)) < 3.5 ||
            max(most.x, most.y) - min(least.x, least.y) > kDoubtfulSpread;
    return sum > 0.0 ? dot(weights, quad.visibility) / sum : -1.0;
}

// The same where none of the four is on the surface, as at edges that are finer than a texel: by the
// sixteen about it, whichever are near in space. Negative where not `needed`.
float sampleNeighbours(vec3 p, Grid grid, vec2 at, vec2 code, bool needed) {
    float footprint = 2.0 * p.z / float(uFaceSize);
    ivec2 first = ivec2(floor(at)) - 1;
    float sum = 0.0;
    float weights = 0.0;
    float scale = -1.0 / (footprint * footprint);
    int i = 0;
    do {
        ivec2 corner = clamp(first + 2 * ivec2(i & 1, i >> 1), ivec2(0), grid.extent - 2);
        Quad quad = quadAt(grid, corner, code);
        vec4 x = quad.depth * quad.s - p.x;
        vec4 y = quad.depth * quad.t - p.y;
        vec4 z = quad.depth - p.z;
        vec4 distance2 = x * x + y * y + z * z;
        vec4 weight = exp2(max(scale * distance2, -100.0)) * quad.known;
        sum += dot(weight, quad.visibility);
        weights += dot(weight, vec4(1.0));
    } while (needed && ++i < 4);
    return needed && weights > kLeastWeight ? sum / weights : -1.0;
}

float fourthPower(float x) {
    float square = x * x;
    return square * square;
}

// How long texels may be on a surface, world units.
// @param footprint  of the pixel, square on
// @param facing     cosine of the surface to the viewer
float longestTexel(float footprint, float facing) {
    return max(kLongestOfReach * uReach, kLongestOfPixel * footprint / max(facing, kMostGrazing));
}

// How far from a point's plane its texels may lie; negative where it is seen from less than half a texel
// above it and may well lie between the texels' rays, and where these are too long.
float planeTolerance(vec3 p, float depth, float facing, float scale, float resolution, float longest) {
    float cosDelta = facing * inversesqrt(dot(p, p));
    float texels = scale * float(uFaceSize);
    return cosDelta * texels >= 1.0 && 2.0 * depth <= longest * texels * cosDelta
               ? kPlaneFootprints * 2.0 * depth / (texels * max(cosDelta, kSteepest)) + resolution
               : -1.0;
}

// Adds what one cube map's faces know of a point.
// @param eyeTo       from the eye to the point, world axes
// @param resolution  how much the point's depth may be wrong, world units
// @param longest     how long texels may be on the surface, world units
void project(int cube, vec3 eyeTo, vec3 normal, float resolution, float longest, inout Projected best) {
    vec3 p = uCubeToEye[cube].xyz + eyeTo;
    float facing = -dot(normal, p);
    if (!(facing > 0.0)) {
        return; // the cube map sees the other side, if any
    }
    float distance2 = dot(p, p);
    vec3 a = abs(p);
    float depth = max(a.x, max(a.y, a.z));
    float quality = qualityFactor(distance2, depth, facing) * uCubeToEye[cube].w;
    if (quality < kLeastShare * best.quality) {
        return;
    }
    int face = faceOf(p);
    int layer = faceLayer(cube, face);
    if (layer == kNoLayer) {
        return;
    }
    vec3 inFace = toFace(face, p);
    vec3 normalInFace = toFace(face, normal);
    vec2 uv = inFace.xy / inFace.z * 0.5 + 0.5;
    vec2 at = uv * float(uFaceSize);
    bool lowConfidence;
    float visibility =
        sampleBilinear(inFace, normalInFace, wholeFace(layer), at - 0.5, uDepthCode[cube].xy,
               planeTolerance(p, depth, facing, 1.0, resolution, longest), kAnywhere, lowConfidence);
    if (visibility < 0.0) {
        if (quality > best.fallbackQuality) {
            best.fallbackQuality = quality;
            best.fallbackCube = cube;
        }
        return;
    }
    if (quality > best.quality) {
        float fade = fourthPower(best.quality / quality);
        best = Projected(best.sum * fade + visibility, best.weights * fade + 1.0, quality, cube, face,
                         uv, best.fallbackCube, best.fallbackQuality, lowConfidence);
    } else {
        float weight = fourthPower(quality / best.quality);
        best.sum += weight * visibility;
        best.weights += weight;
    }
}

// The same of the cube maps from `first` to before `end`. The loop asks at its end: a software rasteriser,
// which has no branches but a loop's way back, would run its body once more to find that nobody goes on.
void projectAll(int first, int end, vec3 eyeTo, vec3 normal, float resolution, float longest,
                inout Projected best) {
    int cube = first;
    if (cube < end) {
        do {
            project(cube, eyeTo, normal, resolution, longest, best);
        } while (++cube < end);
    }
}

// Notes a cube map that sees a point's direction as one to fallbackCube by: what project() does in passing,
// for those of earlier passes.
void consider(int cube, vec3 eyeTo, vec3 normal, inout Projected best) {
    vec3 p = uCubeToEye[cube].xyz + eyeTo;
    float facing = -dot(normal, p);
    vec3 a = abs(p);
    float quality = qualityFactor(dot(p, p), max(a.x, max(a.y, a.z)), facing) * uCubeToEye[cube].w;
    if (facing > 0.0 && faceLayer(cube, faceOf(p)) != kNoLayer && quality > best.fallbackQuality) {
        best.fallbackQuality = quality;
        best.fallbackCube = cube;
    }
}

// After all cube maps: where a tile of the best is kept finer, what its finer texels know stands for all;
// where none knows the surface, what the one that might knows of it in its page, or nearby. Apart from
// project(), because a software rasteriser runs every branch, for each cube map again; only loops end
// when no pixel of a group goes on.
void refine(vec3 eyeTo, vec3 normal, float resolution, float longest, inout Projected best) {
    bool unknown = best.weights <= 0.0;
    if (unknown && best.fallbackCube < 0) {
        return;
    }
    int cube = unknown ? best.fallbackCube : best.cube;
    vec3 p = uCubeToEye[cube].xyz + eyeTo;
    int face = faceOf(p);
    vec3 inFace = toFace(face, p);
    vec2 uv = inFace.xy / inFace.z * 0.5 + 0.5;
    vec2 at = uv * float(uFaceSize);
    vec2 code = uDepthCode[cube].xy;
    int layer = faceLayer(cube, face);
    float visibility = -1.0;
#ifdef AO_PAGES
    int edge = kTile * uPageScale;
    float scale = float(uPageScale);
    float tolerance = planeTolerance(p, inFace.z, -dot(normal, p), scale, resolution, longest);
    float apart = uPageScale == 1 ? kBehindTolerances * tolerance : kAnywhere;
    ivec2 tile = min(ivec2(at), uFaceSize - 1) / kTile;
    ivec3 link = ivec3(tile, layer);
    bool behind;
    do { // from page to page, which lie behind each other
        ivec2 page = ivec2(texelFetch(uPages, link, 0).rg * 65535.0 + 0.5);
        bool paged = page.x > 0 && (uPageScale > 1 || unknown);
        link = ivec3(page.y & 255, page.y >> 8, page.x - 1);
        Grid grid = Grid(max(link.z, 0), edge * link.xy, tile * edge,
                         min(ivec2(edge), uPageScale * uFaceSize - tile * edge), uPageScale);
        bool lowConfidence;
        float ofPage = sampleBilinear(inFace, toFace(face, normal), grid, scale * at - vec2(grid.offset) - 0.5,
                            code, tolerance, apart, lowConfidence);
        visibility = paged ? ofPage : visibility;
        best.lowConfidence = paged ? lowConfidence || ofPage < 0.0 : best.lowConfidence;
        behind = paged && uPageScale == 1 && ofPage < 0.0;
    } while (behind);
#endif
    bool nearby = unknown && visibility < 0.0;
    float about = sampleNeighbours(inFace, wholeFace(layer), at - 0.5, code, nearby);
    best.lowConfidence = best.lowConfidence || unknown && visibility < 0.0;
    visibility = nearby ? about : visibility;
    if (visibility >= 0.0) {
        best.sum = visibility;
        best.weights = 1.0;
        best.face = face;
        best.uv = uv;
    }
}
