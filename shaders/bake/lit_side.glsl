// Which way a surface faces the light. Positions lie in the scene's frame.
uniform vec3 uDirection; // towards the light, unit length
uniform vec4 uGround;    // up, and the ground's height along it; up is 0 where there is none
uniform float uReach;    // the ground occludes no farther than that, frame units

// What lies within this share of the frame is taken to stand on the ground.
const float kGroundTolerance = 1e-5;

// The cosine about the shading normal, 0 where light comes from below the triangle's plane or the
// ground.
// @param normal  shading normal, any length; 0 where there is none
// @param plane   the triangle's own, unit length, on the side from which its corners turn left
float litCosine(vec3 position, vec3 normal, vec3 plane) {
    float size = length(normal);
    vec3 unit = size > 0.0 ? normal / size : plane;
    vec3 side = dot(plane, unit) < 0.0 ? -plane : plane;
    if (dot(side, uDirection) <= 0.0) {
        return 0.0;
    }
    float rise = dot(uDirection, uGround.xyz);
    float height = dot(position, uGround.xyz) - uGround.w;
    bool belowGround = height >= -kGroundTolerance ? rise < 0.0 : rise > 0.0;
    if (belowGround && abs(height) < uReach * abs(rise)) {
        return 0.0;
    }
    return max(0.0, dot(unit, uDirection));
}
