#version 330 core
// Stage 1 for vertices: which triangle is lit, and where.
uniform int uFirst; // number of the draw call's first triangle, from 1

in vec3 vPosition;

layout(location = 0) out vec4 oPoint; // place in the frame; number of the triangle from 1, 0 for none

void main() {
    oPoint = vec4(vPosition, float(uFirst + gl_PrimitiveID));
}
