#version 330 core
// The estimator of layered intervals on the host's own view: one layer, as thick as a constant. The
// slices then contain the eye, and what lies outside the picture is not known.
#include "frame/geometry.glsl"

uniform float uThickness; // world units

const int uLayers = 1;

struct Texel {
    ivec2 at;
};

bool texelTowards(vec3 direction, out Texel texel) {
    texel.at = ivec2(0);
    if (direction.z >= 0.0) {
        return false;
    }
    vec2 window = windowPosition(direction);
    texel.at = ivec2(floor(window));
    return all(greaterThanEqual(window, vec2(0.0))) && all(lessThan(window, uViewSize));
}

vec3 rayOf(Texel texel) { return normalize(eyePositionAt(texel.at, 1.0)); }

vec4 intervalAt(Texel texel, int layer) {
    float t = depthAt(texel.at);
    float distance = length(eyePositionAt(texel.at, t));
    vec3 normal = worldNormalAt(texel.at) * uEyeToWorld;
    return t < 0.0 ? vec4(-1.0) : vec4(distance, distance + uThickness, encodeNormal(normal));
}

float texelAngle() { return pixelFootprint(1.0); }
float footprintAt(Texel texel, vec3 position) { return pixelFootprint(-position.z); }
vec3 slicesFrom(Texel texel) { return vec3(1.0, 0.0, 0.0); }

#include "estimators/layered_intervals.glsl"

layout(location = 0) out vec2 outBest; // W, log2 of quality

void main() {
    Texel texel = Texel(ivec2(gl_FragCoord.xy));
    float t = depthAt(texel.at);
    outBest = vec2(1.0, 0.0);
    if (t >= 0.0) {
        vec3 normal = worldNormalAt(texel.at) * uEyeToWorld;
        uint seed = uint(texel.at.x) + uint(uViewSize.x) * uint(texel.at.y);
        outBest.r = clamp(
            visibilityLayeredIntervals(texel, seed, eyePositionAt(texel.at, t), encodeNormal(normal)), 0.0, 1.0);
    }
}
