#version 330 core
// The host's surfaces: eye space is kept for lighting, so far-off worlds cost no precision.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;

uniform mat4 modelView;
uniform mat4 projection;
uniform mat3 normalMatrix;

out vec3 eyePosition;
out vec3 eyeNormal;

void main() {
    vec4 eye = modelView * vec4(position, 1.0);
    eyePosition = eye.xyz;
    eyeNormal = normalMatrix * normal;
    gl_Position = projection * eye;
}
