#version 330 core
// Two triangles over each tile that has pixels whose samples may show several surfaces; nothing of the
// others.
uniform sampler2D uTiles; // edge_tiles.frag's
uniform int uTileSize;    // pixels along a tile's edge
uniform vec2 uViewSize;   // pixels

const int kVertices = 6; // of a tile

void main() {
    int number = gl_VertexID / kVertices;
    int vertex = gl_VertexID % kVertices;
    int across = textureSize(uTiles, 0).x;
    ivec2 tile = ivec2(number % across, number / across);
    // Corners 0 1 2, 2 1 3.
    int corner = vertex < 3 ? vertex : vertex == 3 ? 2 : vertex == 4 ? 1 : 3;
    bool any = texelFetch(uTiles, tile, 0).r > 0.0;
    ivec2 at = uTileSize * (tile + (any ? ivec2(corner & 1, corner >> 1) : ivec2(0)));
    gl_Position = vec4(min(vec2(at), uViewSize) / uViewSize * 2.0 - 1.0, 0.0, 1.0);
}
