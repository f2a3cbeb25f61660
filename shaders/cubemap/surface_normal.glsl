// The normal of the side of a surface that faces the cube's centre.
uniform bool uHasNormals;

// @param position  relative to the cube's centre
// @param given     the host's normal, if it gave any
vec3 seenNormal(vec3 position, vec3 given) {
    vec3 geometric = cross(dFdx(position), dFdy(position));
    float size = dot(geometric, geometric);
    geometric = size > 0.0 && !isinf(size) ? geometric * inversesqrt(size) : -normalize(position);
    geometric = dot(geometric, position) > 0.0 ? -geometric : geometric;
    float length2 = dot(given, given);
    if (!uHasNormals || !(length2 > 0.0)) {
        return geometric;
    }
    vec3 normal = given * inversesqrt(length2);
    return dot(normal, geometric) < 0.0 ? -normal : normal;
}
