#pragma once

#include <aolib/AbstractTexelTracer.h>

namespace aolib {

/// Whether surfaces end or bend within a tile, so that its texels do not show all of it.
bool isRough(const TracedTexels& traced);

} // namespace aolib
