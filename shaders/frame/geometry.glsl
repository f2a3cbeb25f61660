// Reads what geometry_buffer.frag wrote.
#include "shared/octahedral.h"
#include "frame/host_view.glsl"

uniform sampler2D uLinearDepth;
uniform sampler2D uNormal;

// Linear depth of a pixel; negative where nothing was drawn.
float depthAt(ivec2 pixel) { return texelFetch(uLinearDepth, pixel, 0).r; }
vec3 worldNormalAt(ivec2 pixel) { return decodeNormal(texelFetch(uNormal, pixel, 0).rg); }
vec3 eyePositionAt(ivec2 pixel, float t) { return eyePosition(vec2(pixel) + 0.5, t); }
