// What the peeling stages share: the fragment, and what begins or ends there. A solid is entered and
// left. A sheet of which only one side is to be seen is a lid: what lies behind that side, up to the
// next surface, is taken as solid. Any other sheet has no thickness.
#include "cubemap/entry_kinds.glsl"

in vec3 vPosition;
in vec3 vNormal;
flat in float vSolid;
flat in float vSheet;
flat in float vLid;

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

// Whether solid begins, or ends, behind a fragment of a sheet.
bool opensLid() { return vLid != 0.0 && frontFaces() == (vLid > 0.0); }
bool closesLid() { return vLid != 0.0 && frontFaces() != (vLid > 0.0); }
