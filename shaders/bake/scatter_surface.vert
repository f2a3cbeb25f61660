#version 330 core
// The model as light from one direction sees it.
layout(location = 0) in vec3 aPosition;
layout(location = 1) in vec3 aNormal;
layout(location = 2) in vec3 aPlace; // u, v, number of the map; -1: it only occludes

uniform mat4 uToLight;

out vec3 vPosition;
out vec3 vNormal;
out vec3 vPlace;

void main() {
    vPosition = aPosition;
    vNormal = aNormal;
    vPlace = aPlace;
    gl_Position = uToLight * vec4(aPosition, 1.0);
}
