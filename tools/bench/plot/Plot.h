#pragma once

#include <string>
#include <vector>

#include "bench/plot/Drawing.h"

namespace aolib::bench {

enum class Marker { Disc, Square, Diamond, TriangleUp, TriangleDown, Ring };

/// A measured value with a label beside it.
struct PlotPoint {
    double x = 0.0;
    double y = 0.0;
    std::string label; ///< empty for none
};

/// Points of one kind, joined by a line in their order.
struct Curve {
    std::string name; ///< for the legend; empty: not in it
    Colour colour;
    Marker marker = Marker::Disc;
    std::vector<PlotPoint> points;
    double width = 2.0;  ///< of the line, pixels; 0 for no line
    double dash = 0.0;   ///< see Polyline
    bool markers = true; ///< at every point
};

/// What an axis says. Values are shown on a logarithmic scale, or a linear one from 0.
struct Axis {
    std::string title;
    bool logarithmic = true;
};

/// Curves over two axes. Points that a logarithmic axis cannot show, not above 0, are left out.
struct Plot {
    std::string title;
    std::string subtitle;
    Axis x;
    Axis y;
    std::vector<Curve> curves;
    std::vector<std::string> notes; ///< small lines below everything
};

/// The plot, laid out.
Drawing layOut(const Plot& plot);

} // namespace aolib::bench
