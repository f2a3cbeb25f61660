// Behind environmentShader(). A diffuse surface under an environment and a sun: linear radiance.
in vec3 worldPosition;
in vec3 worldNormal;
in vec4 openCone;
in vec4 plainCone;
in vec4 sectorShares[6];

uniform int method; // LitMethod
uniform sampler2DArray cones;
uniform sampler2DArray sectors;
uniform sampler2D environment;
uniform samplerCube angles;
uniform vec3 baseColour;      // linear
uniform vec3 eyePosition;
uniform vec3 sunDirection;    // towards it, unit
uniform vec3 sunIrradiance;   // 0: there is none
uniform sampler2D sunDepth;   // from the sun, 0 to 1
uniform mat4 worldToLight;    // to the sun's depth, 0 to 1 each way
uniform float sunTexel;       // of that depth, world units

layout(location = 0) out vec4 radiance;

const int IRRADIANCE = 0;
const int BLURRED = 1;
const int BLURRED_BY_ANGLES = 2;
const int SECTORS = 5;
const float INVERSE_PI_OF_LIGHT = 0.318309886;
const int SUN_REACH = 1; // texels to each side that are asked

// The share of the sun that its depth map shows, between texels as filtering would have it.
float sunVisibility(vec3 normal) {
    float slope = sqrt(max(0.0, 1.0 - dot(normal, sunDirection) * dot(normal, sunDirection)));
    vec3 lifted = worldPosition + normal * (2.0 * sunTexel * slope) + sunDirection * sunTexel;
    vec3 at = (worldToLight * vec4(lifted, 1.0)).xyz;
    vec2 size = vec2(textureSize(sunDepth, 0));
    vec2 texel = at.xy * size - 0.5;
    vec2 corner = floor(texel);
    vec2 part = texel - corner;
    float open = 0.0;
    float all = 0.0;
    for (int y = -SUN_REACH; y <= SUN_REACH + 1; ++y) {
        for (int x = -SUN_REACH; x <= SUN_REACH + 1; ++x) {
            vec2 weight = vec2(x == -SUN_REACH ? 1.0 - part.x : x == SUN_REACH + 1 ? part.x : 1.0,
                               y == -SUN_REACH ? 1.0 - part.y : y == SUN_REACH + 1 ? part.y : 1.0);
            vec2 place = (corner + vec2(x, y) + 0.5) / size;
            float depth = textureLod(sunDepth, place, 0.0).r;
            all += weight.x * weight.y;
            open += depth >= at.z ? weight.x * weight.y : 0.0;
        }
    }
    return open / all;
}

vec3 unit(vec3 v, vec3 otherwise) {
    float size = length(v);
    return size > 0.0 ? v / size : otherwise;
}

void main() {
    vec3 normal = normalize(worldNormal);
    normal = dot(normal, eyePosition - worldPosition) < 0.0 ? -normal : normal;
    vec3 light;
    if (method == IRRADIANCE) {
        light = aoIrradianceLight(cones, normal, openCone.w);
    } else if (method == BLURRED) {
        light = aoBlurredLight(environment, unit(plainCone.xyz, normal), plainCone.w);
    } else if (method == BLURRED_BY_ANGLES) {
        light = aoBlurredLightByAngles(environment, angles, unit(plainCone.xyz, normal), plainCone.w);
    } else if (method == SECTORS) {
        light = aoSectorLight(sectors, normal, sectorShares);
    } else {
        light = aoConeLight(cones, normal, unit(openCone.xyz, normal), openCone.w);
    }
    if (sunIrradiance != vec3(0.0)) {
        float cosine = max(dot(normal, sunDirection), 0.0);
        if (cosine > 0.0) {
            light += sunIrradiance * (cosine * INVERSE_PI_OF_LIGHT * sunVisibility(normal));
        }
    }
    radiance = vec4(baseColour * light, 1.0);
}
