#version 330 core
// Lambert under one directional light and a hemisphere of sky above and ground below; no shadows.
in vec3 eyePosition;
in vec3 eyeNormal;

uniform vec3 baseColour;     // linear
uniform bool hasNormals;     // else the triangle's own, from derivatives
uniform bool perspective;    // else orthographic: every pixel looks along -z
uniform vec3 lightDirection; // eye space, towards the light, unit
uniform vec3 upDirection;    // eye space, unit

layout(location = 0) out vec4 colour;

const vec3 SUN = vec3(0.62, 0.58, 0.50);
const vec3 SKY = vec3(0.52, 0.57, 0.64);
const vec3 GROUND = vec3(0.30, 0.28, 0.26);
const float DISPLAY_GAMMA = 2.2;

vec3 shadingNormal() {
    vec3 n = hasNormals ? eyeNormal : cross(dFdx(eyePosition), dFdy(eyePosition));
    float size = length(n);
    vec3 towardsViewer = perspective ? -eyePosition : vec3(0.0, 0.0, 1.0);
    if (!(size > 0.0)) {
        return normalize(towardsViewer);
    }
    return dot(n, towardsViewer) < 0.0 ? -n / size : n / size;
}

void main() {
    vec3 n = shadingNormal();
    vec3 ambient = mix(GROUND, SKY, 0.5 + 0.5 * dot(n, upDirection));
    vec3 direct = SUN * max(dot(n, lightDirection), 0.0);
    colour = vec4(pow(baseColour * (ambient + direct), vec3(1.0 / DISPLAY_GAMMA)), 1.0);
}
