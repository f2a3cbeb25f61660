#version 330 core
// The debug views of the thesis; numbers as in enum class DebugView.
#include "frame/geometry.glsl"
#include "frame/surface_edge.glsl"

uniform sampler2D uVisibility; // blurred: W, shaded
uniform sampler2D uProjected;  // before the blur: sum of W, log2 of quality, face's code, weight
uniform ivec2 uOrigin;
uniform int uView;
uniform float uRadius;
uniform float uSceneSize; // diagonal of the scene's bounding box
uniform vec3 uEye;        // world position of the camera, modulo the positions' period

layout(location = 0) out vec4 outColour;

const int kAmbientOcclusion = 1;
const int kQuality = 2;
const int kFaces = 3;
const int kCoverage = 4;
const int kEdges = 5;
const int kPositions = 6;
const int kNormals = 7;

const vec3 kUnshadedColour = vec3(1.0, 0.05, 0.05);
const vec3 kEdgeColour = vec3(0.1, 0.9, 0.2);

// Red over yellow to green for x in [0,1].
vec3 falseColour(float x) { return clamp(vec3(2.0 - 2.0 * x, 2.0 * x, 0.1), 0.0, 1.0); }

vec3 faceColour(float code) {
    int face = int(fract(code) * 8.0 + 0.5);
    vec3 axis = face < 2 ? vec3(1.0, 0.35, 0.3) : face < 4 ? vec3(0.4, 0.9, 0.4) : vec3(0.35, 0.5, 1.0);
    return (face & 1) == 0 ? axis : axis * 0.55;
}

bool isEdge(ivec2 pixel, float t) {
    vec3 position = eyePositionAt(pixel, t);
    vec3 normal = worldNormalAt(pixel) * uEyeToWorld;
    float tolerance = sameSurfaceTolerance(t);
    for (int i = 0; i < 4; ++i) {
        ivec2 step = i < 2 ? ivec2(2 * i - 1, 0) : ivec2(0, 2 * i - 5);
        ivec2 other = clamp(pixel + step, ivec2(0), ivec2(uViewSize) - 1);
        float otherT = depthAt(other);
        if (otherT < 0.0 || !sameSurface(position, normal, tolerance, eyePositionAt(other, otherT),
                                         worldNormalAt(other) * uEyeToWorld)) {
            return true;
        }
    }
    return false;
}

vec3 colourOf(ivec2 pixel, float t) {
    vec2 visibility = texelFetch(uVisibility, pixel, 0).rg;
    vec4 projected = texelFetch(uProjected, pixel, 0);
    bool shaded = visibility.g > 0.75;
    if (uView == kAmbientOcclusion) {
        return vec3(visibility.r);
    }
    if (uView == kQuality) {
        // Q times the squared size of the scene: 0 when seen from one scene's size away, 16 from 1/256.
        float x = (projected.g + 2.0 * log2(uSceneSize)) / 16.0;
        return shaded ? falseColour(clamp(x, 0.0, 1.0)) : vec3(0.15);
    }
    if (uView == kFaces) {
        return shaded ? faceColour(projected.b) * (fract(projected.b * 8.0 + 0.5) > 0.8 ? 0.2 : 1.0)
                      : vec3(0.15);
    }
    if (uView == kCoverage) {
        return visibility.g > 0.25 && shaded ? vec3(visibility.r) : kUnshadedColour;
    }
    if (uView == kEdges) {
        return isEdge(pixel, t) ? kEdgeColour : vec3(0.25 + 0.5 * visibility.r);
    }
    if (uView == kPositions) {
        return fract((uEyeToWorld * eyePositionAt(pixel, t) + uEye) / uRadius);
    }
    return worldNormalAt(pixel) * 0.5 + 0.5;
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy) - uOrigin;
    float t = depthAt(pixel);
    outColour = vec4(t < 0.0 ? vec3(1.0) : colourOf(pixel, t), 1.0);
}
