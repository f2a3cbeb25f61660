#version 330 core
// Points spread evenly over the charts, for stage 2: their sum is what of each texel is covered.
#include "bake/footprint.glsl"

uniform float uSampleArea; // square texels per pixel

in vec2 vTexel;
in vec3 vPosition;
flat in float vFacet;

layout(location = 0) out vec4 oPoint;
layout(location = 1) out vec2 oSize;

void main() {
    oPoint = vec4(vTexel, vFacet, uSampleArea);
    oSize = footprint(dFdx(vPosition), dFdy(vPosition), dFdx(vTexel), dFdy(vTexel));
}
