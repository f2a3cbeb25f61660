#version 330 core
// The factor that the host's colours are multiplied by: (1 - a) + a W, thesis eq. 4.11.
uniform sampler2D uVisibility;
uniform ivec2 uOrigin; // lower left corner of the host's viewport, pixels
uniform float uContrast;
#ifdef AO_EDGES
uniform sampler2D uEdges; // resolve_samples.frag's: these pixels are blend_samples.frag's
#endif

layout(location = 0) out vec4 outFactor;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy) - uOrigin;
#ifdef AO_EDGES
    if (texelFetch(uEdges, pixel, 0).r > 0.0) {
        discard;
    }
#endif
    vec2 visibility = texelFetch(uVisibility, pixel, 0).rg;
    if (visibility.r < 0.0) {
        discard;
    }
    outFactor = vec4(vec3(1.0 - uContrast + uContrast * visibility.r), 1.0);
}
