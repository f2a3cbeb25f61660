#version 330 core
// A texel gets the share of the point that lies in it, if it shows the same facet: not what happens to
// lie beside it in the map.
uniform vec3 uDirection;  // towards the light
uniform float uPointSize; // texels
uniform sampler2DArray uFacets; // of each texel of the target

flat in vec2 vPlace;
flat in float vWeight;
flat in float vFacet;
flat in vec2 vSides;

layout(location = 0) out vec4 oSum; // weighed direction, weight

void main() {
    float share = 1.0;
    if (uPointSize > 0.0) {
        vec2 low = max(gl_FragCoord.xy - 0.5, vPlace - 0.5 * vSides);
        vec2 high = min(gl_FragCoord.xy + 0.5, vPlace + 0.5 * vSides);
        vec2 sides = max(high - low, 0.0);
        share = sides.x * sides.y / (vSides.x * vSides.y);
    }
    float facet = texelFetch(uFacets, ivec3(gl_FragCoord.xy, 0), 0).r;
    if (share == 0.0 || facet != vFacet) {
        discard;
    }
    oSum = vec4(uDirection, 1.0) * (share * vWeight);
}
