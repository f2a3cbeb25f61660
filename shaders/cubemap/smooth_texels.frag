#version 330 core
// Takes sampling noise out of a cube map: each texel becomes the mean of itself, which counts more, and
// of those about it that lie on its surface, over the borders of faces as well. Distances go through
// as they are.
#include "cubemap/kept_texel.glsl"
#include "cubemap/layered_view.glsl"

uniform sampler2D uAccumulated; // six faces side by side: blocked weight, weight
uniform int uFace;

// Texels to each side.
const int kReach = 1;
// How much the texel itself counts beside each of the others: less leaves noise, more takes away what
// is true within a texel's distance (docs/accuracy.md).
const float kOwnWeight = 4.0;
// Distance from the tangent plane, in texel footprints, and cosine between normals (25 degrees) that
// still count as the same surface.
const float kSameSurfaceFootprints = 0.5;
const float kSameSurfaceCosine = 0.906;

void main() {
    Texel texel = Texel(uFace, ivec2(gl_FragCoord.xy));
    vec4 own = intervalAt(texel, 0);
    if (own.x < 0.0) {
        keepNothing();
        return;
    }
    vec3 position = rayOf(texel) * own.x;
    vec3 normal = decodeNormal(own.zw);
    float tolerance = kSameSurfaceFootprints * footprintAt(texel, position);
    vec2 found = vec2(0.0);
    for (int i = 0; i < (2 * kReach + 1) * (2 * kReach + 1); ++i) {
        ivec2 offset = ivec2(i % (2 * kReach + 1), i / (2 * kReach + 1)) - kReach;
        vec2 uv = (vec2(texel.at + offset) + 0.5) / float(uFaceSize);
        Texel other;
        texelTowards(faceDirection(texel.face, uv), other);
        vec4 interval = intervalAt(other, 0);
        bool same = interval.x > 0.0 &&
                    abs(dot(normal, rayOf(other) * interval.x - position)) <= tolerance &&
                    dot(normal, decodeNormal(interval.zw)) >= kSameSurfaceCosine;
        if (same || offset == ivec2(0)) {
            float weight = offset == ivec2(0) ? kOwnWeight : 1.0;
            found += weight *
                     texelFetch(uAccumulated, other.at + ivec2(other.face * uFaceSize, 0), 0).rg;
        }
    }
    keep(found.y > 0.0 ? 1.0 - found.x / found.y : 1.0, dot(position, faceForward(uFace)));
}
