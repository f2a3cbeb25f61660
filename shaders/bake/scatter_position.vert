#version 330 core
// The model as light from one direction sees it, for vertices to which the processor adds it up.
layout(location = 0) in vec3 aPosition;

uniform mat4 uToLight;

out vec3 vPosition;

void main() {
    vPosition = aPosition;
    gl_Position = uToLight * vec4(aPosition, 1.0);
}
