#version 330 core
// Stage 2: each pixel of stage 1 is a point, read where its number says.
uniform sampler2D uSurface; // place in the target, texels; facet, 0 for none; weight
uniform sampler2D uSize;    // least sides of the point, texels
uniform int uWidth;         // of the part of the picture that is used, pixels
uniform vec2 uTargetSize;   // texels
uniform float uPointSize;   // texels; 0: the nearest texel gets all

flat out vec2 vPlace;
flat out float vWeight;
flat out float vFacet;
flat out vec2 vSides;

void main() {
    ivec2 pixel = ivec2(gl_VertexID % uWidth, gl_VertexID / uWidth);
    vec4 point = texelFetch(uSurface, pixel, 0);
    vSides = max(vec2(uPointSize), texelFetch(uSize, pixel, 0).xy);
    vPlace = point.xy;
    vWeight = point.w;
    vFacet = point.z;
    bool nothing = point.z * point.w <= 0.0;
    // The smallest square of whole texels that holds the point; its middle stays in the target, where
    // points are not cut off.
    vec2 low = max(floor(vPlace - 0.5 * vSides), 0.0);
    vec2 high = min(ceil(vPlace + 0.5 * vSides), uTargetSize);
    float side = uPointSize > 0.0 ? max(high.x - low.x, high.y - low.y) : 1.0;
    vec2 middle = uPointSize > 0.0 ? min(low + 0.5 * side, uTargetSize) : vPlace;
    gl_PointSize = side;
    // What is outside is not drawn.
    gl_Position = nothing ? vec4(2.0, 2.0, 2.0, 1.0)
                          : vec4(middle / uTargetSize * 2.0 - 1.0, 0.0, 1.0);
}
