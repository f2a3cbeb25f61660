#version 330 core
// The twelve edges of a wire cube, as 24 vertices made from their number.
uniform mat4 uCubeToClip; // world axes about the cube's centre to the host's clip space
uniform float uHalfEdge;  // world units

void main() {
    int edge = gl_VertexID >> 1;
    int axis = edge >> 2;
    vec3 corner = vec3((gl_VertexID & 1) * 2 - 1, (edge & 1) * 2 - 1, (edge & 2) - 1);
    vec3 p = axis == 0 ? corner.xyz : axis == 1 ? corner.zxy : corner.yzx;
    gl_Position = uCubeToClip * vec4(p * uHalfEdge, 1.0);
}
