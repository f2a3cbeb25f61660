#pragma once

#include "bench/plot/Drawing.h"
#include "image/Image.h"

namespace aolib::bench {

/// The drawing in pixels, RGB, the bottom row first; edges are smoothed.
/// @param scale  pixels of the picture per pixel of the drawing.
ByteImage paint(const Drawing& drawing, double scale);

} // namespace aolib::bench
