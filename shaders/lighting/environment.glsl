// Environment lighting for a host's own shaders of GLSL 3.30 or later; docs/environment.md. What it
// returns is what a white diffuse surface sends out: multiply by its colour. Directions are in the
// space of the map.
#include "shared/lat_long.h"
#include "shared/open_cone.h"

// Where a direction lies in a table whose rows begin and end at the poles.
vec2 aoTablePlace(vec3 direction, float rows) {
    vec2 place = latLongPlace(direction);
    return vec2(place.x, (place.y * (rows - 1.0) + 0.5) / rows);
}

// The mean radiance in a cone about `axis` that takes `share` of the cosine-weighed hemisphere.
vec3 aoConeRadiance(sampler2DArray cones, vec3 axis, float share) {
    vec3 size = vec3(textureSize(cones, 0));
    float last = size.z - 1.0;
    float layer = last * coneAperture(share);
    float lower = min(floor(layer), last - 1.0);
    vec2 place = aoTablePlace(axis, size.y);
    return mix(textureLod(cones, vec3(place, lower), 0.0).rgb,
               textureLod(cones, vec3(place, lower + 1.0), 0.0).rgb, layer - lower);
}

// By visibility W and bent normal: the cone of open directions. All unit vectors. Here and below
// what interpolation put outside 0 and 1 is cut.
vec3 aoConeLight(sampler2DArray cones, vec3 normal, vec3 bentNormal, float visibility) {
    return clamp(visibility, 0.0, 1.0) *
           aoConeRadiance(cones, bentNormal, coneShare(visibility, dot(normal, bentNormal)));
}

// By how open each of 24 sectors of directions is, four a vector, in their order.
vec3 aoSectorLight(sampler2DArray sectors, vec3 normal, vec4 open[6]) {
    vec2 place = aoTablePlace(normal, float(textureSize(sectors, 0).y));
    vec3 light = vec3(0.0);
    for (int i = 0; i < 6; ++i) {
        vec4 share = clamp(open[i], 0.0, 1.0);
        for (int k = 0; k < 4; ++k) {
            light += share[k] * textureLod(sectors, vec3(place, float(4 * i + k)), 0.0).rgb;
        }
    }
    return light;
}

// Ambient occlusion times irradiance: visibility W darkens what an open surface would send out.
vec3 aoIrradianceLight(sampler2DArray cones, vec3 normal, float visibility) {
    return clamp(visibility, 0.0, 1.0) * aoConeRadiance(cones, normal, 1.0);
}

// GPU Gems, chapter 17, listing 17-5: how far to blur, in shares of the map.
void computeBlur(float accessibility, out vec2 blurX, out vec2 blurY) {
    float width = sqrt(accessibility);
    blurX = vec2(width, 0.0);
    blurY = vec2(0.0, width);
}

// GPU Gems, chapter 17, listing 17-3: accessibility (the plain share of open directions) times a
// blurred lookup at `place` of a map with mipmaps.
vec3 aoBlurredLightAt(sampler2D map, vec2 place, float accessibility) {
    vec2 blurX;
    vec2 blurY;
    float open = clamp(accessibility, 0.0, 1.0);
    computeBlur(open, blurX, blurY);
    return open * textureGrad(map, place, blurX, blurY).rgb;
}

vec3 aoBlurredLight(sampler2D map, vec3 bentNormal, float accessibility) {
    return aoBlurredLightAt(map, latLongPlace(bentNormal), accessibility);
}

// The same with the place from a cube map of angles.
vec3 aoBlurredLightByAngles(sampler2D map, samplerCube angles, vec3 bentNormal,
                            float accessibility) {
    return aoBlurredLightAt(map, textureLod(angles, bentNormal, 0.0).rg, accessibility);
}
