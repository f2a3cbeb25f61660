#version 330 core
// Which tiles of the picture have pixels whose samples may show several surfaces: 1 or 0.
uniform sampler2D uEdges; // resolve_samples.frag's, filtered
uniform int uTileSize;    // pixels along a tile's edge, even

layout(location = 0) out float outAny;

void main() {
    vec2 texel = 1.0 / vec2(textureSize(uEdges, 0));
    vec2 first = float(uTileSize) * floor(gl_FragCoord.xy) + 1.0; // between four pixels
    float any = 0.0;
    int y = 0;
    do {
        int x = 0;
        do {
            any += textureLod(uEdges, (first + 2.0 * vec2(x, y)) * texel, 0.0).r;
        } while (2 * ++x < uTileSize);
    } while (2 * ++y < uTileSize);
    outAny = any > 0.0 ? 1.0 : 0.0;
}
