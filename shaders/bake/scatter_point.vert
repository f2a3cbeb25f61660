#version 330 core
// Stage 2: each pixel of stage 1 is a point, read where its number says.
uniform sampler2D uSurface; // place in the target, texels; 1 or 0; weight
uniform sampler2D uSize;    // least sides of the point, texels
uniform vec2 uTargetSize;   // texels
uniform float uPointSize;   // texels; 0: the nearest texel gets all

flat out vec2 vPlace;
flat out float vWeight;
flat out vec2 vSides;

// A square this much larger than the point covers the centres of all texels that the point touches,
// however the driver rounds sizes.
const float kMargin = 1.5;

void main() {
    int width = textureSize(uSurface, 0).x;
    ivec2 pixel = ivec2(gl_VertexID % width, gl_VertexID / width);
    vec4 point = texelFetch(uSurface, pixel, 0);
    vSides = max(vec2(uPointSize), texelFetch(uSize, pixel, 0).xy);
    vPlace = point.xy;
    vWeight = point.w;
    bool nothing = point.z * point.w <= 0.0;
    gl_PointSize = uPointSize > 0.0 ? max(vSides.x, vSides.y) + kMargin : 1.0;
    // What is outside is not drawn.
    gl_Position = nothing ? vec4(2.0, 2.0, 2.0, 1.0)
                          : vec4(point.xy / uTargetSize * 2.0 - 1.0, 0.0, 1.0);
}
