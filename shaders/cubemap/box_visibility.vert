#version 330 core
// The twelve triangles of a box, as 36 vertices made from their number, seen by one cube face.
uniform vec3 uBoxMin; // relative to the cube's centre
uniform vec3 uBoxMax;
uniform mat3 uCubeToFace;
uniform vec2 uDepthMap;

out float vDepth; // along the face's axis

const int kCorners[6] = int[6](0, 1, 2, 2, 1, 3);

void main() {
    int side = gl_VertexID / 6;
    int corner = kCorners[gl_VertexID - 6 * side];
    int axis = side >> 1;
    vec3 unit = vec3(side & 1, corner & 1, corner >> 1);
    unit = axis == 0 ? unit.xyz : axis == 1 ? unit.zxy : unit.yzx;
    vec3 face = uCubeToFace * mix(uBoxMin, uBoxMax, unit);
    vDepth = face.z;
    gl_Position = vec4(face.xy, uDepthMap.x * face.z + uDepthMap.y, face.z);
}
