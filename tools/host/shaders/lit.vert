#version 330 core
// Surfaces in world space with what was baked of their vertices.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 open;  // bent normal by the cosine, visibility W
layout(location = 3) in vec4 plain; // mean open direction, share of open directions
layout(location = 4) in vec4 openSectors[6]; // how open each sector of directions is

uniform mat4 viewProjection;

out vec3 worldPosition;
out vec3 worldNormal;
out vec4 openCone;
out vec4 plainCone;
out vec4 sectorShares[6];

void main() {
    worldPosition = position;
    worldNormal = normal;
    openCone = open;
    plainCone = plain;
    sectorShares = openSectors;
    gl_Position = viewProjection * vec4(position, 1.0);
}
