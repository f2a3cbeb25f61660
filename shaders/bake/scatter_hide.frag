#version 330 core
// Of a slab's picture, takes away what is no farther behind the slab before than a slab is thick: drawn
// over all pixels where its depth is above theirs.
uniform sampler2D uBefore; // the slab before, from behind: 0 at the border, 1 where there is nothing

layout(location = 0) out vec4 oPoint;
layout(location = 1) out vec2 oSize;

void main() {
    gl_FragDepth = 1.0 - texelFetch(uBefore, ivec2(gl_FragCoord.xy), 0).r;
    oPoint = vec4(0.0);
    oSize = vec2(0.0);
}
