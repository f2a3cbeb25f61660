#version 330 core
// The charts of the stacked maps laid out flat, a tile of them at a time.
layout(location = 0) in vec3 aPosition;
layout(location = 2) in vec4 aPlace; // u, v, map, -1: it only occludes; facet

uniform vec2 uMapSize;    // texels
uniform int uFirstMap;
uniform int uMapCount;
uniform vec2 uTileOrigin; // texels
uniform float uTileSize;  // texels

out vec2 vTexel;
flat out float vFacet;
out vec3 vPosition;

void main() {
    vPosition = aPosition;
    vFacet = aPlace.w;
    int map = int(round(aPlace.z));
    vTexel = aPlace.xy * uMapSize + vec2(0.0, float(map - uFirstMap) * uMapSize.y);
    bool inStack = aPlace.z > -0.5 && map >= uFirstMap && map < uFirstMap + uMapCount;
    gl_Position = inStack ? vec4((vTexel - uTileOrigin) / uTileSize * 2.0 - 1.0, 0.0, 1.0)
                          : vec4(2.0, 2.0, 2.0, 1.0);
}
