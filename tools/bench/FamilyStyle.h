#pragma once

#include "bench/MethodTable.h"
#include "bench/plot/Plot.h"

namespace aolib::bench {

/// How a family is drawn, the same in every plot.
struct FamilyStyle {
    Colour colour;
    Marker marker = Marker::Disc;
    double width = 1.6;
    double dash = 0.0;
};

FamilyStyle styleOf(Family family);

} // namespace aolib::bench
