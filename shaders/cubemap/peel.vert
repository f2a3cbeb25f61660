#version 330 core
// Geometry on its way to one face of a cube map, for peeling solid intervals.
layout(location = 0) in vec3 aPosition;
layout(location = 1) in vec3 aNormal;
layout(location = 2) in float aSolid; // 0 for a sheet, else 1 + the number of the mesh's solid

uniform mat4 uModelToCube;  // world axes, origin at the cube's centre
uniform mat3 uNormalMatrix; // inverse transpose of the model matrix
uniform mat3 uCubeToFace;   // rows right, up, forward
uniform vec2 uDepthMap;     // clip z = x * depth + y
uniform float uFirstSolid;  // solids of the meshes before this one

out vec3 vPosition; // relative to the cube's centre
out vec3 vNormal;
flat out float vSolid; // unique in the scene; 0 for a sheet

void main() {
    vPosition = (uModelToCube * vec4(aPosition, 1.0)).xyz;
    vNormal = uNormalMatrix * aNormal;
    vSolid = aSolid > 0.0 ? uFirstSolid + aSolid : 0.0;
    vec3 face = uCubeToFace * vPosition;
    gl_Position = vec4(face.xy, uDepthMap.x * face.z + uDepthMap.y, face.z);
}
