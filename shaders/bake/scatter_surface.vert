#version 330 core
// The model as light from one direction sees it.
layout(location = 0) in vec3 aPosition;
layout(location = 1) in vec3 aNormal;
layout(location = 2) in vec4 aPlace; // u, v, map, -1: it only occludes; facet

uniform mat4 uToLight;

out vec3 vPosition;
out vec3 vNormal;
out vec2 vUv;
flat out vec2 vOwner; // map, facet

void main() {
    vPosition = aPosition;
    vNormal = aNormal;
    vUv = aPlace.xy;
    vOwner = aPlace.zw;
    gl_Position = uToLight * vec4(aPosition, 1.0);
}
