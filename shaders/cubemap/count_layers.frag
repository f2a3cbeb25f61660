#version 330 core
// Adds one for each interval that begins along a ray: how many layers there are to peel.
#include "cubemap/peel.glsl"

layout(location = 0) out float outCount;

void main() {
    if (vSolid > 0.0 ? !enters() : closesShell()) {
        discard;
    }
    outCount = 1.0 / 255.0;
}
