#version 330 core
// One triangle over the viewport, and where each of its corners looks.
uniform mat4 inverseProjection;
uniform mat3 eyeToWorld;

out vec3 worldDirection;

void main() {
    vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
    gl_Position = vec4(corner, 0.0, 1.0);
    vec4 eye = inverseProjection * vec4(corner, 0.0, 1.0);
    worldDirection = eyeToWorld * (eye.xyz / eye.w);
}
