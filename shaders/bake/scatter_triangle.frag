#version 330 core
// Stage 1 for points that the processor adds up: which triangle is lit, and where in the map.
uniform int uFirst; // number of the draw call's first triangle, from 1

in vec2 vUv;

layout(location = 0) out vec4 oPoint; // u, v; number of the triangle from 1, 0 for none

void main() {
    oPoint = vec4(vUv, float(uFirst + gl_PrimitiveID), 0.0);
}
