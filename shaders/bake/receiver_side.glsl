// Whether a receiver faces the light, and where it asks for it. Positions lie in the scene's frame.
uniform float uBias;  // texels of the depth map by which a receiver on a slope is lifted
uniform vec4 uGround; // up, and the ground's height along it; up is 0 for none

const float kGroundTolerance = 1e-5;

// @param direction  towards the light, unit length
// @param reach      the ground occludes no farther than that
bool facesLight(vec3 position, vec3 plane, vec3 direction, float reach) {
    float rise = dot(direction, uGround.xyz);
    float height = dot(position, uGround.xyz) - uGround.w;
    bool belowGround = height >= -kGroundTolerance ? rise < 0.0 : rise > 0.0;
    return dot(plane, direction) > 0.0 && !(belowGround && abs(height) < reach * abs(rise));
}

// The depth map's nearest texel lies up to half a texel's diagonal h away, where a plane at the angle
// theta is nearer to the light by h tan(theta). A point lifted by h sin(theta) off the plane is that
// much before it, and never moves far: through no wall but one thinner than a texel.
// @param texel  a depth map's, frame units
vec3 lifted(vec3 position, vec3 plane, vec3 direction, float texel) {
    float facing = dot(plane, direction);
    return position + plane * (uBias * texel * sqrt(max(0.0, 1.0 - facing * facing)));
}
