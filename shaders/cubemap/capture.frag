#version 330 core
// Geometry as a cube map sees it: the normal of the side it sees, and the distance along the ray.
#include "cubemap/surface_normal.glsl"

in vec3 vPosition;
in vec3 vNormal;

layout(location = 0) out vec4 outGeometry; // normal, distance

void main() {
    outGeometry = vec4(seenNormal(seenPlane(vPosition), vNormal), length(vPosition));
}
