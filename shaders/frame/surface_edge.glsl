// Whether two pixels lie on one surface: the second on the first's tangent plane, normals alike.
// (The thesis compares depths by 0.01 and hashed normals by 0.1; a plane needs no constant of scale.)

// Distance from the tangent plane, in pixel footprints, that still counts as the same surface.
const float kSameSurfaceFootprints = 1.5;
// Cosine of the angle between two normals of the same surface: 25 degrees.
const float kSameSurfaceCosine = 0.906;

bool sameSurface(vec3 position, vec3 normal, float tolerance, vec3 otherPosition,
                 vec3 otherNormal) {
    return abs(dot(normal, otherPosition - position)) <= tolerance &&
           dot(normal, otherNormal) >= kSameSurfaceCosine;
}

float sameSurfaceTolerance(float t) {
    return kSameSurfaceFootprints * pixelFootprint(t) + 2.0 * depthResolution(t);
}
