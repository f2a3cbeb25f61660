// The normals of the side of a surface that faces the cube's centre.
uniform bool uHasNormals;

// Of the triangle. @param position  relative to the cube's centre
vec3 seenPlane(vec3 position) {
    vec3 geometric = cross(dFdx(position), dFdy(position));
    float size = dot(geometric, geometric);
    geometric = size > 0.0 && !isinf(size) ? geometric * inversesqrt(size) : -normalize(position);
    return dot(geometric, position) > 0.0 ? -geometric : geometric;
}

// What it is shaded about. @param given  the host's normal, if it gave any
vec3 seenNormal(vec3 plane, vec3 given) {
    float length2 = dot(given, given);
    if (!uHasNormals || !(length2 > 0.0)) {
        return plane;
    }
    vec3 normal = given * inversesqrt(length2);
    return dot(normal, plane) < 0.0 ? -normal : normal;
}
