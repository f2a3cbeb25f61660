#version 330 core
// Geometry as a cube map sees it: the normal of the side it sees, and the distance along the ray.
in vec3 vPosition;
in vec3 vNormal;

uniform bool uHasNormals;

layout(location = 0) out vec4 outGeometry; // normal, distance

void main() {
    float distance = length(vPosition);
    vec3 ray = vPosition / distance;
    vec3 geometric = cross(dFdx(vPosition), dFdy(vPosition));
    float size = dot(geometric, geometric);
    geometric = size > 0.0 && !isinf(size) ? geometric * inversesqrt(size) : -ray;
    geometric = dot(geometric, ray) > 0.0 ? -geometric : geometric;
    vec3 normal = geometric;
    float given = dot(vNormal, vNormal);
    if (uHasNormals && given > 0.0) {
        normal = vNormal * inversesqrt(given);
        normal = dot(normal, geometric) < 0.0 ? -normal : normal;
    }
    outGeometry = vec4(normal, distance);
}
