#version 330 core
// Coverage for a small target (thesis 4.6): each of its pixels looks at 4 x 4 points of its part of
// the screen. Output: share with geometry, share shaded by a cube map.
uniform sampler2D uLinearDepth;
uniform sampler2D uVisibility; // blurred: W, shaded
uniform vec2 uViewSize;
uniform vec2 uTargetSize;

layout(location = 0) out vec2 outCoverage;

const int kPoints = 4;

void main() {
    vec2 corner = (gl_FragCoord.xy - 0.5) / uTargetSize;
    vec2 spacing = 1.0 / (uTargetSize * float(kPoints));
    vec2 counts = vec2(0.0);
    for (int y = 0; y < kPoints; ++y) {
        for (int x = 0; x < kPoints; ++x) {
            ivec2 pixel = ivec2((corner + (vec2(x, y) + 0.5) * spacing) * uViewSize);
            if (texelFetch(uLinearDepth, pixel, 0).r >= 0.0) {
                counts += vec2(1.0, texelFetch(uVisibility, pixel, 0).g > 0.75 ? 1.0 : 0.0);
            }
        }
    }
    outCoverage = counts / float(kPoints * kPoints);
}
