#version 330 core
// Shadow maps of occluders that reach no farther than a slab is thick, read for each receiver: of its own
// slab what is nearest to the light, of the slab before it what is farthest from it.
#include "bake/receiver_side.glsl"

const int kMost = 16;

uniform sampler2DArray uReceivers; // layer 0: position in the frame, 1 where there is one;
                                   // 1: shading normal; 2: the triangle's own, on its side
uniform sampler2D uDepth;
uniform ivec2 uTiles;            // depth maps beside each other; texels along one
uniform int uCount;              // runs: slabs of one direction, one after the other
uniform mat4 uToLight[kMost];    // from the frame to clip space of each run's direction
uniform vec4 uAxes[kMost];       // slabs up to a position: (axis, 1) times (position, 1)
uniform vec4 uRuns[kMost];       // first slab, their number, first pair of depth maps; reach, frame units
uniform vec4 uDirections[kMost]; // towards each light; and a depth map's texel, frame units

layout(location = 0) out vec4 oSum; // weighed direction, weight

// Rounding of depths, in units of the frame.
const float kLeastBias = 2e-6;

float depthAt(int tile, vec2 place) {
    ivec2 texel = clamp(ivec2(place * float(uTiles.y)), ivec2(0), ivec2(uTiles.y - 1));
    return texelFetch(uDepth, ivec2(tile % uTiles.x, tile / uTiles.x) * uTiles.y + texel, 0).r;
}

float visibility(int i, vec3 position, vec3 normal, vec3 plane) {
    vec3 direction = uDirections[i].xyz;
    vec3 place = lifted(position, plane, direction, uDirections[i].w);
    float coordinate = dot(uAxes[i], vec4(place, 1.0));
    float slab = floor(coordinate);
    float number = slab - uRuns[i].x;
    if (number < 0.0 || number >= uRuns[i].y ||
        !facesLight(position, plane, direction, uRuns[i].w)) {
        return 0.0;
    }
    float leastBias = kLeastBias * length(uAxes[i].xyz);
    vec2 at = (uToLight[i] * vec4(place, 1.0)).xy * 0.5 + 0.5;
    int tile = 2 * int(uRuns[i].z + number);
    // Slabs between the border of its own and what is nearest in it, what is farthest before it.
    float after = depthAt(tile, at);
    float before = depthAt(tile + 1, at);
    bool lit = coordinate - slab - leastBias <= after &&
               before + dot(uAxes[i], vec4(position, 1.0)) - slab >= 1.0;
    return lit ? max(0.0, dot(normal, direction)) : 0.0;
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
