#version 330 core
// The side that each ray's nearest surface shows, to find the open meshes that only ever show one.
#include "cubemap/peel.glsl"

// 0 a solid, 2 n the back of the open mesh n, 2 n + 1 its front; -1 where there is nothing.
layout(location = 0) out float outSide;

void main() { outSide = vOpenMesh > 0.0 ? 2.0 * vOpenMesh + (frontFaces() ? 1.0 : 0.0) : 0.0; }
