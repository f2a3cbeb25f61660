// 64 sectors of equal weight over a slice's hemisphere, one bit each; set bits are blocked
// (Therrien, Levesque and Gilet 2023, "Screen Space Indirect Lighting with Visibility Bitmask").
#ifdef __cplusplus
#pragma once
#endif
#include "shared/dual.h"

// The lowest n bits of 32.
AO_FUNCTION uint lowestBits(int n) {
    return n <= 0 ? 0u : n >= 32 ? 0xFFFFFFFFu : (1u << uint(n)) - 1u;
}

// Sectors from a to b, shares of the hemisphere in [0,1], rounded so that a sector counts when its
// middle lies between them.
AO_FUNCTION uvec2 sectorsBetween(float a, float b) {
    int from = int(a * 64.0f + 0.5f);
    int to = int(b * 64.0f + 0.5f);
    return uvec2(lowestBits(to) & ~lowestBits(from), lowestBits(to - 32) & ~lowestBits(from - 32));
}

AO_FUNCTION uint bitsSet(uint x) {
    x = x - ((x >> 1u) & 0x55555555u);
    x = (x & 0x33333333u) + ((x >> 2u) & 0x33333333u);
    return (((x + (x >> 4u)) & 0x0F0F0F0Fu) * 0x01010101u) >> 24u;
}

AO_FUNCTION float shareSet(uvec2 mask) {
    return float(bitsSet(mask.x) + bitsSet(mask.y)) / 64.0f;
}

AO_SHARED_END
