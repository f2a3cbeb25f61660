#version 330 core
// The next surface along each ray, behind the interval peeled before: an open mesh, or where solid begins.
#include "cubemap/peel.glsl"
#include "cubemap/surface_normal.glsl"
#include "shared/normal_pair.h"

uniform sampler2D uPrevious; // the layer before: distance, solid, normal
uniform sampler2D uExit;     // and where it ended, as peel_exit.frag says
uniform bool uFirstLayer;

// Where two surfaces meet, the one that faces the cube's centre more is the nearer one: by this share of
// what depth changes by from texel to texel. Rounding would choose now the one, now the other.
const float kCreaseShare = 0.01;

layout(location = 0) out vec4 outEntry; // distance, solid or kOpenMeshEntry or kShellEntry, normals

void main() {
    // Before any discard: the plane needs its neighbours.
    vec3 plane = seenPlane(vPosition);
    gl_FragDepth = gl_FragCoord.z + kCreaseShare * fwidth(gl_FragCoord.z);
    float distance = length(vPosition);
    if (vSolid > 0.0 && !enters()) {
        discard;
    }
    if (!uFirstLayer) {
        float before = texelFetch(uPrevious, ivec2(gl_FragCoord.xy), 0).r;
        if (before < 0.0) {
            discard;
        }
        before = max(before, -texelFetch(uExit, ivec2(gl_FragCoord.xy), 0).r);
        if (distance <= before * (1.0 + kSameSurface)) {
            discard;
        }
    }
    float what = vSolid > 0.0 ? vSolid : opensShell() ? kShellEntry : kOpenMeshEntry;
    vec3 normal = seenNormal(plane, vNormal);
    outEntry = vec4(distance, what, normal == plane ? encodeNormal(plane) : encodeNormals(plane, normal));
}
