#version 330 core
layout(location = 0) in vec3 aPosition;
layout(location = 1) in vec3 aNormal;

uniform mat4 uModelToCube;  // world axes, origin at the cube's centre
uniform mat3 uNormalMatrix; // inverse transpose of the model matrix
uniform mat3 uCubeToFace;   // rows right, up, forward
uniform vec2 uDepthMap;     // clip z = x * depth + y

out vec3 vPosition; // relative to the cube's centre
out vec3 vNormal;

void main() {
    vPosition = (uModelToCube * vec4(aPosition, 1.0)).xyz;
    vec3 normal = uNormalMatrix * aNormal;
    float length2 = dot(normal, normal);
    vNormal = length2 > 0.0 ? normal * inversesqrt(length2) : vec3(0.0); // long ones weigh no more
    vec3 face = uCubeToFace * vPosition;
    gl_Position = vec4(face.xy, uDepthMap.x * face.z + uDepthMap.y, face.z);
}
