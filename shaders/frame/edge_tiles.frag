#version 330 core
// Which tiles of the picture have pixels whose samples show several surfaces: 1 or 0.
uniform sampler2D uEdges; // resolve_samples.frag's
uniform int uTileSize;    // pixels along a tile's edge

layout(location = 0) out float outAny;

void main() {
    ivec2 first = uTileSize * ivec2(gl_FragCoord.xy);
    ivec2 end = min(first + uTileSize, textureSize(uEdges, 0));
    float any = 0.0;
    for (int y = first.y; y < end.y; ++y) {
        for (int x = first.x; x < end.x; ++x) {
            any = max(any, texelFetch(uEdges, ivec2(x, y), 0).r);
        }
    }
    outAny = any > 0.0 ? 1.0 : 0.0;
}
