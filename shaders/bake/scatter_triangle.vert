#version 330 core
// The model as light from one direction sees it, for points that the processor adds up.
layout(location = 0) in vec3 aPosition;
layout(location = 2) in vec4 aPlace; // u, v; map, facet

uniform mat4 uToLight;

out vec2 vUv;

void main() {
    vUv = aPlace.xy;
    gl_Position = uToLight * vec4(aPosition, 1.0);
}
