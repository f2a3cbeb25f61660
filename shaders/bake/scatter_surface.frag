#version 330 core
// Stage 1 (McGraw and Sowers 2008, section 3): where in the map the light falls, and how much.
#include "bake/footprint.glsl"
#include "bake/lit_side.glsl"

uniform vec2 uMapSize;     // texels
uniform int uFirstMap;     // of those that are stacked in the target
uniform int uMapCount;
uniform float uDensity;    // square texels per square frame unit, or 0: the Jacobian says

in vec3 vPosition;
in vec3 vNormal;
in vec2 vUv;
flat in vec2 vOwner; // map, facet

layout(location = 0) out vec4 oPoint; // place in the stack of maps, texels; facet, 0 for none; weight
layout(location = 1) out vec2 oSize;  // of the pixel in the map, texels

// At a grazing angle a shading normal and the plane part: a pixel counts at most so much more than one
// that faces the light. What is cut off is less than 1/20 of such a surface's share.
const float kMostGrazing = 20.0;

void main() {
    int map = int(round(vOwner.x));
    if (vOwner.x < -0.5 || map < uFirstMap || map >= uFirstMap + uMapCount) {
        oPoint = vec4(0.0);
        oSize = vec2(0.0);
        return;
    }
    vec3 across = dFdx(vPosition);
    vec3 up = dFdy(vPosition);
    vec3 areaVector = cross(across, up); // towards the viewer, who is the light
    float area = length(areaVector);
    vec3 plane = area > 0.0 ? areaVector / area : uDirection;
    plane = gl_FrontFacing ? plane : -plane;
    float cosine = litCosine(vPosition, vNormal, plane);
    vec2 texel = vUv * uMapSize;
    vec2 dx = dFdx(texel);
    vec2 dy = dFdy(texel);
    float jacobian = abs(dx.x * dy.y - dx.y * dy.x);
    if (uDensity > 0.0) {
        jacobian = uDensity * area;
    }
    float grazing = abs(dot(plane, uDirection));
    float weight = jacobian * min(cosine, kMostGrazing * grazing);
    oPoint = vec4(texel + vec2(0.0, float(map - uFirstMap) * uMapSize.y), vOwner.y, weight);
    oSize = footprint(across, up, dx, dy);
}
