#version 330 core
// The background: haze at the horizon, blue above, a dull floor of fog below. Display encoded.
in vec3 worldDirection;

layout(location = 0) out vec4 colour;

const vec3 ZENITH = vec3(0.42, 0.58, 0.78);
const vec3 HORIZON = vec3(0.86, 0.89, 0.92);
const vec3 NADIR = vec3(0.60, 0.60, 0.60);

void main() {
    float height = normalize(worldDirection).y;
    colour = vec4(height > 0.0 ? mix(HORIZON, ZENITH, sqrt(height))
                               : mix(HORIZON, NADIR, min(-4.0 * height, 1.0)), 1.0);
}
