#version 330 core
// The horizon-split estimator on the host's own view. Positions are in eye space.
#include "frame/geometry.glsl"

bool surfaceAt(vec2 uv, out vec3 position, out vec3 normal) {
    ivec2 pixel = ivec2(uv * uViewSize);
    float t = depthAt(pixel);
    position = eyePositionAt(pixel, t);
    normal = worldNormalAt(pixel) * uEyeToWorld;
    return t >= 0.0;
}

vec2 viewCoordinates(vec3 position) { return windowPosition(position) / uViewSize; }
// An orthographic view has no behind: every step stays in front.
float viewDepth(vec3 position) { return uClipOffset.w == 0.0 ? 1.0 : -position.z; }
vec2 viewTexel() { return 1.0 / uViewSize; }

#include "estimators/horizon_split.glsl"

layout(location = 0) out vec2 outBest; // W, log2 of quality

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float t = depthAt(pixel);
    outBest = vec2(1.0, 0.0);
    if (t >= 0.0) {
        outBest.r = clamp(visibilityHorizonSplit(eyePositionAt(pixel, t),
                                                 worldNormalAt(pixel) * uEyeToWorld),
                          0.0, 1.0);
    }
}
