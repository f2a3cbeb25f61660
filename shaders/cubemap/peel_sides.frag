#version 330 core
// The side that each ray's nearest surface shows, to find which sheets only ever show one.
#include "cubemap/peel.glsl"

// 0 a solid, 2 n the back of the sheet n, 2 n + 1 its front; -1 where there is nothing.
layout(location = 0) out float outSide;

void main() { outSide = vSheet > 0.0 ? 2.0 * vSheet + (frontFaces() ? 1.0 : 0.0) : 0.0; }
