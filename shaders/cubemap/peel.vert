#version 330 core
// Geometry on its way to one face of a cube map, for peeling solid intervals.
layout(location = 0) in vec3 aPosition;
layout(location = 1) in vec3 aNormal;
layout(location = 2) in float aSolid; // as Solids::solidOfVertex

uniform mat4 uModelToCube;    // world axes, origin at the cube's centre
uniform mat3 uNormalMatrix;   // inverse transpose of the model matrix
uniform mat3 uCubeToFace;     // rows right, up, forward
uniform vec2 uDepthMap;       // clip z = x * depth + y
uniform float uFirstSolid;    // numbers of the meshes before this one
uniform float uUnusual[128];  // open meshes that are no shells: their numbers, negative where only backs show
uniform int uUnusualCount;

out vec3 vPosition; // relative to the cube's centre
out vec3 vNormal;
flat out float vSolid; // unique in the scene; 0 for an open mesh
flat out float vOpenMesh; // unique in the scene; 0 for a solid
// Which side of an open mesh has solid behind it: 1 the front, -1 the back, 0 neither.
flat out float vShell;

const float kOpenMeshes = 4194304.0; // as Solids::kOpenMesh

float shellOf(float openMesh) {
    for (int i = 0; i < uUnusualCount; ++i) {
        if (abs(uUnusual[i]) == openMesh) {
            return uUnusual[i] < 0.0 ? -1.0 : 0.0;
        }
    }
    return 1.0;
}

void main() {
    vPosition = (uModelToCube * vec4(aPosition, 1.0)).xyz;
    vec3 normal = uNormalMatrix * aNormal;
    float length2 = dot(normal, normal);
    vNormal = length2 > 0.0 ? normal * inversesqrt(length2) : vec3(0.0); // long ones weigh no more
    bool openMesh = aSolid >= kOpenMeshes;
    vSolid = openMesh ? 0.0 : uFirstSolid + aSolid;
    vOpenMesh = openMesh ? uFirstSolid + (aSolid - kOpenMeshes) : 0.0;
    vShell = openMesh ? shellOf(vOpenMesh) : 0.0;
    vec3 face = uCubeToFace * vPosition;
    gl_Position = vec4(face.xy, uDepthMap.x * face.z + uDepthMap.y, face.z);
}
