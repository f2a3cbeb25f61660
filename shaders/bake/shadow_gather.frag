#version 330 core
// Several shadow maps, which lie side by side in one texture, read for each receiver (GPU Gems,
// chapter 17.3).
#include "bake/receiver_side.glsl"

const int kMost = 16;

uniform sampler2DArray uReceivers; // layer 0: position in the frame, 1 where there is one;
                                   // 1: shading normal; 2: the triangle's own, on its side
uniform sampler2D uDepth;
uniform int uCount;              // shadow maps in use
uniform mat4 uToLight[kMost];    // from the frame to clip space of each
uniform vec4 uTile[kMost];       // of each in the texture: scale and offset of [0,1]^2
uniform vec4 uDirections[kMost]; // towards each light; and a depth map's texel, frame units

layout(location = 0) out vec4 oSum; // weighed direction, weight

// Rounding of depths, in units of clip space.
const float kLeastBias = 1e-6;
const float kNoEnd = 1e30;

float visibility(int i, vec3 position, vec3 normal, vec3 plane) {
    vec3 direction = uDirections[i].xyz;
    if (!facesLight(position, plane, direction, kNoEnd)) {
        return 0.0;
    }
    vec3 place = lifted(position, plane, direction, uDirections[i].w);
    vec3 clip = (uToLight[i] * vec4(place, 1.0)).xyz * 0.5 + 0.5;
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
