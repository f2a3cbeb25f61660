// The host's view, rebuilt from its depth buffer. Lengths are world units; "eye space" has the
// world's scale, x right, y up, and looks along -z. Set by HostCamera::setUniforms().
uniform vec2 uViewSize;      // pixels
uniform vec4 uDepthToLinear; // n0 n1 d0 d1: depth along the axis = (n0 + n1 e) / (d0 + d1 e), e = d - far
uniform float uDepthFar;     // the depth buffer's value at the far end: nothing was drawn there
uniform float uDepthQuantum; // step of the depth buffer's values
uniform vec4 uClipToEye;     // 1/P00, 1/P11, P20, P21
uniform vec4 uClipOffset;    // P30, P31, w0, w1: clip w = w0 + w1 t; y flips with the sign of 1/P11
uniform mat3 uEyeToWorld;    // rotation

// Distance along the view axis from a value of the depth buffer.
float linearDepth(float d) {
    float e = d - uDepthFar;
    return (uDepthToLinear.x + uDepthToLinear.y * e) / (uDepthToLinear.z + uDepthToLinear.w * e);
}

// How much the linear depth may be wrong because the depth buffer's values are steps.
float depthResolution(float t) {
    // e from t, then dt/de.
    float e = (t * uDepthToLinear.z - uDepthToLinear.x) / (uDepthToLinear.y - t * uDepthToLinear.w);
    float denominator = uDepthToLinear.z + uDepthToLinear.w * e;
    return abs((uDepthToLinear.y * uDepthToLinear.z - uDepthToLinear.x * uDepthToLinear.w) /
               (denominator * denominator)) *
           uDepthQuantum;
}

// Eye-space position of window coordinates (pixels, centres at .5) at linear depth t.
vec3 eyePosition(vec2 window, float t) {
    vec2 ndc = window / uViewSize * 2.0 - 1.0;
    float w = uClipOffset.z + uClipOffset.w * t;
    return vec3((ndc * w + uClipToEye.zw * t - uClipOffset.xy) * uClipToEye.xy, -t);
}

// Window coordinates of an eye-space position.
vec2 windowPosition(vec3 eye) {
    float t = -eye.z;
    float w = uClipOffset.z + uClipOffset.w * t;
    vec2 ndc = (eye.xy / uClipToEye.xy - uClipToEye.zw * t + uClipOffset.xy) / w;
    return (ndc * 0.5 + 0.5) * uViewSize;
}

// World units that a pixel covers at linear depth t, square on.
float pixelFootprint(float t) {
    return abs(2.0 * (uClipOffset.z + uClipOffset.w * t) * uClipToEye.y / uViewSize.y);
}

// The unit vector from an eye-space position towards the viewer.
vec3 towardsViewer(vec3 eye) {
    return uClipOffset.w == 0.0 ? normalize(vec3(-uClipToEye.zw * uClipToEye.xy, 1.0)) : -normalize(eye);
}
