// Behind environmentShader(). The environment itself; its alpha says that no surface is there.
in vec3 worldDirection;

uniform sampler2D environment;

layout(location = 0) out vec4 radiance;

void main() {
    radiance = vec4(textureLod(environment, latLongPlace(worldDirection), 0.0).rgb, 0.0);
}
