#version 330 core
// The model as light from one direction sees it: depth alone.
layout(location = 0) in vec3 aPosition;

uniform mat4 uToLight;

void main() {
    gl_Position = uToLight * vec4(aPosition, 1.0);
}
