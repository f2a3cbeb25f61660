#version 330 core
uniform vec3 uColour;
layout(location = 0) out vec4 outColour;
void main() { outColour = vec4(uColour, 1.0); }
