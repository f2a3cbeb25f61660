#version 330 core
// Projects one cube map onto the host's view (thesis 4.4). Where it knows a pixel's surface and its
// quality beats the best so far, it writes visibility and quality; elsewhere the best so far stays.
#include "frame/geometry.glsl"
#include "shared/cube_faces.h"
#include "shared/distance_code.h"
#include "shared/quality.h"

uniform sampler2D uBest;           // value, log2 of quality: the best so far
uniform sampler2D uCubeVisibility; // six faces side by side
uniform sampler2D uCubeDistance;
uniform int uFaceSize;
uniform vec2 uDistanceCode;
uniform vec3 uCubeToEye; // from the cube's centre to the eye, world units
uniform bool uShowFaces; // debug: write the face's code instead of W

layout(location = 0) out vec2 outBest;

// A texel belongs to the pixel's surface when it lies on the pixel's tangent plane to within this
// many texel footprints (more at grazing angles, where a footprint on the surface is longer).
const float kPlaneFootprints = 0.5;
const float kSteepest = 0.2; // cosine below which the tolerance grows no more
// Share of a face, at its border, that the debug view darkens.
const float kBorder = 0.006;

float faceCode(int face, vec2 uv) {
    vec2 edge = min(uv, 1.0 - uv);
    return (float(face) + (min(edge.x, edge.y) < kBorder ? 0.4 : 0.0)) / 8.0;
}

// Visibility of p by the four texels about it that lie on its surface; negative if there is none.
float lookUp(vec3 p, vec3 normal, int face, vec2 uv, float tolerance) {
    vec2 at = uv * float(uFaceSize) - 0.5;
    vec2 corner = floor(at);
    vec2 f = at - corner;
    float sum = 0.0;
    float weights = 0.0;
    for (int i = 0; i < 4; ++i) {
        ivec2 offset = ivec2(i & 1, i >> 1);
        ivec2 texel = clamp(ivec2(corner) + offset, ivec2(0), ivec2(uFaceSize - 1));
        ivec2 address = texel + ivec2(face * uFaceSize, 0);
        float code = texelFetch(uCubeDistance, address, 0).r;
        vec3 ray = normalize(faceDirection(face, (vec2(texel) + 0.5) / float(uFaceSize)));
        vec3 surface = ray * decodeDistance(code, uDistanceCode.x, uDistanceCode.y);
        if (code > 0.0 && abs(dot(normal, surface - p)) <= tolerance) {
            vec2 near = mix(1.0 - f, f, vec2(offset));
            // Never quite zero: a lone texel in the far corner is better than none.
            float weight = near.x * near.y + 1.0e-3;
            sum += weight * texelFetch(uCubeVisibility, address, 0).r;
            weights += weight;
        }
    }
    return weights > 0.0 ? sum / weights : -1.0;
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    outBest = texelFetch(uBest, pixel, 0).rg;
    float t = depthAt(pixel);
    if (t < 0.0) {
        return;
    }
    vec3 p = uCubeToEye + uEyeToWorld * eyePositionAt(pixel, t);
    vec3 normal = worldNormalAt(pixel);
    float distance = length(p);
    float cosDelta = -dot(normal, p) / distance;
    if (!(cosDelta > 0.0)) {
        return; // the cube map sees the other side, if any
    }
    int face = faceOf(p);
    float cosBeta = dot(p, faceForward(face)) / distance;
    float quality = logQuality(distance, cosBeta, cosDelta);
    if (quality <= outBest.g) {
        return;
    }
    float footprint = 2.0 * dot(p, faceForward(face)) / float(uFaceSize);
    float tolerance = kPlaneFootprints * footprint / max(cosDelta, kSteepest) + depthResolution(t);
    vec2 uv = faceCoordinates(face, p);
    float visibility = lookUp(p, normal, face, uv, tolerance);
    if (visibility >= 0.0) {
        outBest = vec2(uShowFaces ? faceCode(face, uv) : visibility, quality);
    }
}
