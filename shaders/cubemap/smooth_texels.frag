#version 330 core
// Takes sampling noise out of a cube map: each texel becomes the mean of itself, which counts more, and
// of those about it that lie on its surface, over the borders of faces as well. Distances go through
// as they are.
#include "cubemap/kept_texel.glsl"
#include "cubemap/layered_view.glsl"

uniform sampler2D uAccumulated; // blocked weight, weight: six faces side by side, or part of one
uniform int uFace;
uniform int uLayer;             // of surfaces, behind so many others; but for 0 of a tile alone
uniform ivec2 uFaceOrigin;      // where the face's first texel would lie in uAccumulated
uniform ivec2 uKeptOrigin;      // and where in the target

uniform int uReach;       // texels to each side
uniform float uOwnWeight; // of the texel itself beside each of the others

// Distance from the tangent plane, in texel footprints, and cosine between normals (25 degrees) that
// still count as the same surface.
const float kSameSurfaceFootprints = 0.5;
const float kSameSurfaceCosine = 0.906;

void main() {
    Texel texel = Texel(uFace, ivec2(gl_FragCoord.xy) - uKeptOrigin);
    vec4 own = intervalAt(texel, uLayer);
    if (own.x < 0.0) {
        keepNothing();
        return;
    }
    vec3 position = rayOf(texel) * own.x;
    vec3 normal = decodePlane(own.zw);
    float tolerance = kSameSurfaceFootprints * footprintAt(texel, position);
    vec2 found = vec2(0.0);
    ivec2 offset = ivec2(-uReach);
    do { // asks at its end, as in estimators/layered_intervals.glsl
        vec2 uv = (vec2(texel.at + offset) + 0.5) / float(uFaceSize);
        Texel other;
        texelTowards(faceDirection(texel.face, uv), other);
        vec4 interval = intervalAt(other, uLayer);
        bool same = interval.x > 0.0 && (uLayer == 0 || other.face == uFace) &&
                    abs(dot(normal, rayOf(other) * interval.x - position)) <= tolerance &&
                    dot(normal, decodePlane(interval.zw)) >= kSameSurfaceCosine;
        if (same || offset == ivec2(0)) {
            float weight = offset == ivec2(0) ? uOwnWeight : 1.0;
            ivec2 origin = uFaceOrigin + ivec2((other.face - uFace) * uFaceSize, 0);
            found += weight * texelFetch(uAccumulated, other.at + origin, 0).rg;
        }
        bool rowDone = offset.x == uReach;
        offset = ivec2(rowDone ? -uReach : offset.x + 1, rowDone ? offset.y + 1 : offset.y);
    } while (offset.y <= uReach);
    keep(found.y > 0.0 ? 1.0 - found.x / found.y : 1.0, dot(position, faceForward(uFace)));
}
