#include "lighting/DirectionCells.h"

#include <algorithm>
#include <cmath>

namespace aolib::lighting {

Between columnsAt(float place, int count) {
    const float at = place * static_cast<float>(count) - 0.5F;
    const float lower = std::floor(at);
    const int first = static_cast<int>(lower);
    return {(first + count) % count, (first + 1) % count, at - lower};
}

Between stepsAt(float place, int count) {
    const float at = std::clamp(place, 0.0F, 1.0F) * static_cast<float>(count - 1);
    const int lower = std::min(static_cast<int>(at), count - 2);
    return {lower, lower + 1, at - static_cast<float>(lower)};
}

} // namespace aolib::lighting
