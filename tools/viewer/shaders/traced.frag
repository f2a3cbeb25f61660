#version 330 core
// A picture of the viewport's size: colours as they are, or what W does to a host's colours.
uniform sampler2D picture;
uniform bool colours;
uniform float contrast; // how much of W counts

layout(location = 0) out vec4 colour;

void main() {
    vec3 texel = texelFetch(picture, ivec2(gl_FragCoord.xy), 0).rgb;
    float visibility = texel.r < 0.0 ? 1.0 : texel.r; // the background is not darkened
    colour = vec4(colours ? texel : vec3(1.0 - contrast + contrast * visibility), 1.0);
}
