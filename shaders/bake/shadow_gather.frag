#version 330 core
// Several shadow maps, which lie side by side in one texture, read for each receiver (GPU Gems,
// chapter 17.3).
const int kMost = 16;

uniform sampler2DArray uReceivers; // layer 0: position in the frame, 1 where there is one;
                                   // 1: shading normal; 2: the triangle's own, on its side
uniform sampler2D uDepth;
uniform int uCount;              // shadow maps in use
uniform mat4 uToLight[kMost];    // from the frame to clip space of each
uniform vec4 uTile[kMost];       // of each in the texture: scale and offset of [0,1]^2
uniform vec4 uDirections[kMost]; // towards each light; and a depth map's texel, frame units
uniform float uBias;             // texels of the depth map by which a receiver on a slope is lifted
uniform vec4 uGround;            // up, and the ground's height along it; up is 0 for none

layout(location = 0) out vec4 oSum; // weighed direction, weight

const float kGroundTolerance = 1e-5;
// Rounding of depths, in units of clip space.
const float kLeastBias = 1e-6;

float visibility(int i, vec3 position, vec3 normal, vec3 plane) {
    vec3 direction = uDirections[i].xyz;
    float facing = dot(plane, direction);
    float rise = dot(direction, uGround.xyz);
    float height = dot(position, uGround.xyz) - uGround.w;
    bool belowGround = height >= -kGroundTolerance ? rise < 0.0 : rise > 0.0;
    if (facing <= 0.0 || belowGround) {
        return 0.0;
    }
    // The depth map's nearest texel lies up to half a texel's diagonal h away, where a plane at the angle
    // theta is nearer to the light by h tan(theta). A point lifted by h sin(theta) off the plane is that
    // much before it, and never moves far: through no wall but one thinner than a texel.
    float sine = sqrt(max(0.0, 1.0 - facing * facing));
    vec3 lifted = position + plane * (uBias * uDirections[i].w * sine);
    vec3 clip = (uToLight[i] * vec4(lifted, 1.0)).xyz * 0.5 + 0.5;
    vec2 at = clamp(clip.xy, 0.0, 1.0) * uTile[i].xy + uTile[i].zw;
    float depth = texelFetch(uDepth, ivec2(at * vec2(textureSize(uDepth, 0))), 0).r;
    return clip.z - kLeastBias <= depth ? max(0.0, dot(normal, direction)) : 0.0;
}

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    vec4 position = texelFetch(uReceivers, ivec3(texel, 0), 0);
    if (position.w == 0.0) {
        discard;
    }
    vec3 normal = texelFetch(uReceivers, ivec3(texel, 1), 0).xyz;
    vec3 plane = texelFetch(uReceivers, ivec3(texel, 2), 0).xyz;
    vec4 sum = vec4(0.0);
    int i = 0;
    do { // asks at its end: a software rasteriser runs the body once more otherwise
        sum += vec4(uDirections[i].xyz, 1.0) * visibility(i, position.xyz, normal, plane);
    } while (++i < uCount);
    oSum = sum;
}
