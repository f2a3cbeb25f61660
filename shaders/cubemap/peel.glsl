// What the peeling stages share: the fragment, and what begins or ends there. A solid is entered and
// left. An open mesh of which only one side is seen is a one-sided shell: what lies behind that side, up to the
// next surface, is taken as solid. Any other open mesh has no thickness.
#include "cubemap/entry_kinds.glsl"

in vec3 vPosition;
in vec3 vNormal;
flat in float vSolid;
flat in float vOpenMesh;
flat in float vShell;

uniform bool uMirrored;    // the model matrix turns triangles round
uniform float uInside[16]; // solids that contain the cube's centre: there, in and out are exchanged
uniform int uInsideCount;

// Surfaces nearer to each other than this share of their distance are one.
const float kSameSurface = 2.0e-5;

bool frontFaces() { return gl_FrontFacing != uMirrored; }

// Whether the ray enters the fragment's solid here.
bool enters() {
    bool front = frontFaces();
    for (int i = 0; i < uInsideCount; ++i) {
        front = front != (uInside[i] == vSolid);
    }
    return front;
}

// Whether solid begins, or ends, behind a fragment of an open mesh.
bool opensShell() { return vShell != 0.0 && frontFaces() == (vShell > 0.0); }
bool closesShell() { return vShell != 0.0 && frontFaces() != (vShell > 0.0); }
