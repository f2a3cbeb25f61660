// What the peeling stages share: the fragment, and whether its ray enters a solid here or leaves it.
in vec3 vPosition;
in vec3 vNormal;
flat in float vSolid;

uniform bool uMirrored;    // the model matrix turns triangles round
uniform float uInside[16]; // solids that contain the cube's centre: there, in and out are exchanged
uniform int uInsideCount;

bool enters() {
    bool front = gl_FrontFacing != uMirrored;
    for (int i = 0; i < uInsideCount; ++i) {
        front = front != (uInside[i] == vSolid);
    }
    return front;
}

// Surfaces nearer to each other than this share of their distance are one.
const float kSameSurface = 2.0e-5;
