#pragma once

#include "image/Image.h"

namespace aolib {

/// Linear radiance of three channels as a picture for displays: `1 - exp(-exposure * radiance)`,
/// which never clips, encoded with a gamma of 2.2.
/// @param exposure  per unit of radiance, above 0.
ByteImage toneMapped(const FloatImage& radiance, float exposure);

} // namespace aolib
