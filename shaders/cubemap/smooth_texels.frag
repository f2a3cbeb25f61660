#version 330 core
// Takes the sampling noise out of a cube map: each texel becomes the mean of those about it that lie
// on its surface, over the borders of faces as well. Distances go through as they are.
#include "cubemap/kept_texel.glsl"
#include "cubemap/layered_view.glsl"

uniform sampler2D uRaw; // visibility, six faces side by side
uniform int uFace;

// Texels to each side.
const int kReach = 1;
// Distance from the tangent plane, in texel footprints, and cosine between normals (25 degrees) that
// still count as the same surface.
const float kSameSurfaceFootprints = 0.5;
const float kSameSurfaceCosine = 0.906;

void main() {
    Texel texel = Texel(uFace, ivec2(gl_FragCoord.xy) - ivec2(uFace * uFaceSize, 0));
    vec4 own = intervalAt(texel, 0);
    if (own.x < 0.0) {
        keepNothing();
        return;
    }
    vec3 position = rayOf(texel) * own.x;
    vec3 normal = decodeNormal(own.zw);
    float tolerance = kSameSurfaceFootprints * footprintAt(texel, position);
    float sum = 0.0;
    float count = 0.0;
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
            sum += texelFetch(uRaw, other.at + ivec2(other.face * uFaceSize, 0), 0).r;
            count += 1.0;
        }
    }
    keep(sum / count, own.x);
}
