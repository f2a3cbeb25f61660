#version 330 core
// One layer of solid intervals [entry, exit] from what was peeled. A sheet has entry = exit, except
// that the last surface along a ray, with nothing behind it, is taken as infinitely thick.
uniform sampler2D uEntry; // distance, solid, octahedral normal
uniform sampler2D uExit;  // distance, -1 where the ray leaves no solid
uniform sampler2D uNext;  // the next layer's entry, -1 where nothing is left

layout(location = 0) out vec4 outInterval; // entry (-1 none), exit, octahedral normal

const float kInfinite = 1.0e30;

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    vec4 entry = texelFetch(uEntry, texel, 0);
    if (entry.r < 0.0) {
        outInterval = vec4(-1.0, -1.0, 0.0, 0.0);
        return;
    }
    float exit = texelFetch(uExit, texel, 0).r;
    bool last = texelFetch(uNext, texel, 0).r < 0.0;
    outInterval = vec4(entry.r, exit > 0.0 ? exit : last ? kInfinite : entry.r, entry.zw);
}
