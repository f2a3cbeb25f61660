#pragma once

#include <aolib/AbstractTexelTracer.h>

namespace aolib {

/// Whether surfaces end or bend within a tile, so that texels miss detail of the tile.
bool isRough(const TracedTexels& traced);

} // namespace aolib
