#version 330 core
// The horizon-split estimator on the host's own view. Positions are in eye space.
#include "frame/geometry.glsl"

const float kHalfTurn = 3.14159265358979;

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

// An arc about the eye is measured in radians, and where rays are parallel in world units.
bool isParallel() { return uClipOffset.w == 0.0; }
vec3 towardsCentre(vec3 position) { return towardsViewer(position); }
float arcLength(vec3 position, float reach) {
    float distance = length(position);
    float within = distance <= reach ? 0.5 * kHalfTurn : asin(reach / distance);
    return isParallel() ? min(reach, length(uViewSize) * pixelFootprint(1.0)) : within;
}
float arcTexel() { return pixelFootprint(1.0); }
float arcTurn(float arc) { return isParallel() ? 0.0 : arc; }
bool surfaceOnArc(vec3 position, vec3 v, vec3 tangent, float arc, out vec3 emitter, out vec3 normal) {
    vec3 direction = isParallel() ? position + arc * tangent : sin(arc) * tangent - cos(arc) * v;
    bool before = isParallel() || direction.z < 0.0;
    vec2 uv = viewCoordinates(before ? direction : position);
    bool inside = all(greaterThanEqual(uv, vec2(0.0))) && all(lessThan(uv, vec2(1.0)));
    return surfaceAt(inside ? uv : vec2(0.5), emitter, normal) && before && inside;
}

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
