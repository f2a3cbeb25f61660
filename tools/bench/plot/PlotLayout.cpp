#include <algorithm>

#include "bench/plot/AxisScale.h"
#include "bench/plot/LabelPlacement.h"
#include "bench/plot/Plot.h"
#include "bench/plot/StrokeFont.h"

namespace aolib::bench {

namespace {

constexpr double kWidth = 1000.0;
constexpr double kPlotHeight = 480.0;
constexpr double kLeft = 78.0;
constexpr double kRight = 24.0;
constexpr double kTop = 68.0;
constexpr double kBelowAxis = 58.0; ///< tick names and the axis's title
constexpr double kLegendLine = 20.0;
constexpr double kNoteLine = 15.0;
constexpr double kBottom = 12.0;
constexpr std::size_t kLegendColumns = 2;

constexpr double kTitleSize = 18.0;
constexpr double kTextSize = 13.0;
constexpr double kLabelSize = 11.0;
constexpr double kNoteSize = 10.5;
constexpr double kMarkerRadius = 4.5;

constexpr Colour kInk{34, 34, 34};
constexpr Colour kGrey{110, 110, 110};
constexpr Colour kGridMajor{214, 214, 214};
constexpr Colour kGridMinor{238, 238, 238};
constexpr Colour kWhite{255, 255, 255};

/// Corners of markers, for a radius of 1; y downwards.
std::vector<glm::dvec2> cornersOf(Marker marker) {
    switch (marker) {
    case Marker::Square:
        return {{-0.85, -0.85}, {0.85, -0.85}, {0.85, 0.85}, {-0.85, 0.85}};
    case Marker::Diamond:
        return {{0, -1.2}, {1.2, 0}, {0, 1.2}, {-1.2, 0}};
    case Marker::TriangleUp:
        return {{0, -1.15}, {1.1, 0.8}, {-1.1, 0.8}};
    case Marker::TriangleDown:
        return {{0, 1.15}, {1.1, -0.8}, {-1.1, -0.8}};
    case Marker::Disc:
    case Marker::Ring:
        break;
    }
    return {};
}

Shape markerShape(Marker marker, const glm::dvec2& at, const Colour& colour) {
    std::vector<glm::dvec2> corners = cornersOf(marker);
    if (corners.empty()) {
        const bool ring = marker == Marker::Ring;
        return Disc{at, kMarkerRadius - (ring ? 0.8 : 0.0), ring ? kWhite : colour,
                    ring ? colour : kWhite, ring ? 2.0 : 1.0};
    }
    for (glm::dvec2& p : corners) {
        p = at + kMarkerRadius * p;
    }
    return Polygon{std::move(corners), colour, kWhite, 1.0};
}

std::vector<double> valuesOf(const Plot& plot, double PlotPoint::*coordinate) {
    std::vector<double> values;
    for (const Curve& curve : plot.curves) {
        for (const PlotPoint& point : curve.points) {
            values.push_back(point.*coordinate);
        }
    }
    return values;
}

class Layout {
public:
    explicit Layout(const Plot& plot)
        : plot_(plot), x_(valuesOf(plot, &PlotPoint::x), plot.x.logarithmic),
          y_(valuesOf(plot, &PlotPoint::y), plot.y.logarithmic), area_{{kLeft, kTop},
                                                                       {kWidth - kRight,
                                                                        kTop + kPlotHeight}},
          labels_(area_) {}

    Drawing drawing();

private:
    void heading();
    void grid();
    void curves();
    void labels();
    void legend();
    void notes();

    glm::dvec2 at(const PlotPoint& point) const {
        return {area_.low.x + x_.place(point.x) * (area_.high.x - area_.low.x),
                area_.high.y - y_.place(point.y) * (area_.high.y - area_.low.y)};
    }
    bool shows(const PlotPoint& point) const { return x_.shows(point.x) && y_.shows(point.y); }
    void add(Shape shape) { drawing_.shapes.push_back(std::move(shape)); }
    void addText(const std::string& text, const glm::dvec2& position, double size,
                 const Colour& colour, Anchor anchor) {
        add(Text{text, position, size, colour, anchor});
    }

    const Plot& plot_;
    AxisScale x_;
    AxisScale y_;
    Box area_;
    LabelPlacement labels_;
    Drawing drawing_;
    double nextLine_ = 0.0; ///< y where what follows may begin
};

Drawing Layout::drawing() {
    heading();
    grid();
    curves();
    labels();
    nextLine_ = area_.high.y + kBelowAxis;
    legend();
    notes();
    drawing_.width = kWidth;
    drawing_.height = nextLine_ + kBottom;
    return std::move(drawing_);
}

void Layout::heading() {
    add(Text{plot_.title, {kLeft, 30.0}, kTitleSize, kInk, Anchor::Start, false, true});
    addText(plot_.subtitle, {kLeft, 52.0}, kTextSize, kGrey, Anchor::Start);
}

void Layout::grid() {
    for (const Tick& tick : x_.ticks()) {
        const double x = area_.low.x + x_.place(tick.value) * (area_.high.x - area_.low.x);
        add(Polyline{{{x, area_.low.y}, {x, area_.high.y}},
                     tick.text.empty() ? kGridMinor : kGridMajor});
        addText(tick.text, {x, area_.high.y + 18.0}, kTextSize, kInk, Anchor::Middle);
    }
    for (const Tick& tick : y_.ticks()) {
        const double y = area_.high.y - y_.place(tick.value) * (area_.high.y - area_.low.y);
        add(Polyline{{{area_.low.x, y}, {area_.high.x, y}},
                     tick.text.empty() ? kGridMinor : kGridMajor});
        addText(tick.text, {area_.low.x - 8.0, y + 4.5}, kTextSize, kInk, Anchor::End);
    }
    const glm::dvec2 corner{area_.low.x, area_.high.y};
    add(Polyline{{area_.low, corner, area_.high}, kInk, 1.2});
    const glm::dvec2 middle = 0.5 * (area_.low + area_.high);
    addText(plot_.x.title, {middle.x, area_.high.y + 40.0}, kTextSize, kInk, Anchor::Middle);
    add(Text{plot_.y.title, {22.0, middle.y}, kTextSize, kInk, Anchor::Middle, true});
}

void Layout::curves() {
    for (const Curve& curve : plot_.curves) {
        std::vector<glm::dvec2> line;
        for (const PlotPoint& point : curve.points) {
            if (shows(point)) {
                line.push_back(at(point));
            }
        }
        if (curve.width > 0.0 && line.size() > 1) {
            labels_.blockLine(line);
            add(Polyline{std::move(line), curve.colour, curve.width, curve.dash});
        }
    }
    for (const Curve& curve : plot_.curves) {
        for (const PlotPoint& point : curve.points) {
            if (curve.markers && shows(point)) {
                const glm::dvec2 place = at(point);
                labels_.block({place - kMarkerRadius, place + kMarkerRadius});
                add(markerShape(curve.marker, place, curve.colour));
            }
        }
    }
}

void Layout::labels() {
    for (const Curve& curve : plot_.curves) {
        for (const PlotPoint& point : curve.points) {
            if (point.label.empty() || !shows(point)) {
                continue;
            }
            const glm::dvec2 size{textWidth(point.label, kLabelSize), 0.8 * kLabelSize};
            const Box box = labels_.place(at(point), kMarkerRadius, size);
            addText(point.label, {box.low.x, box.high.y}, kLabelSize, curve.colour, Anchor::Start);
        }
    }
}

void Layout::legend() {
    std::vector<const Curve*> named;
    for (const Curve& curve : plot_.curves) {
        if (!curve.name.empty() && std::any_of(curve.points.begin(), curve.points.end(),
                                               [&](const PlotPoint& p) { return shows(p); })) {
            named.push_back(&curve);
        }
    }
    const std::size_t lines = (named.size() + kLegendColumns - 1) / kLegendColumns;
    const double columnWidth = (kWidth - kLeft - kRight) / double(kLegendColumns);
    for (std::size_t i = 0; i < named.size(); ++i) {
        const Curve& curve = *named[i];
        const glm::dvec2 place{kLeft + double(i / lines) * columnWidth,
                               nextLine_ + double(i % lines) * kLegendLine + 4.0};
        add(Polyline{{place, place + glm::dvec2(30.0, 0.0)},
                     curve.colour,
                     std::max(curve.width, 1.0),
                     curve.dash});
        if (curve.markers) {
            add(markerShape(curve.marker, place + glm::dvec2(15.0, 0.0), curve.colour));
        }
        addText(curve.name, place + glm::dvec2(38.0, 4.5), kTextSize, kInk, Anchor::Start);
    }
    nextLine_ += double(lines) * kLegendLine + 8.0;
}

void Layout::notes() {
    for (const std::string& note : plot_.notes) {
        addText(note, {kLeft, nextLine_ + kNoteLine - 3.0}, kNoteSize, kGrey, Anchor::Start);
        nextLine_ += kNoteLine;
    }
}

} // namespace

Drawing layOut(const Plot& plot) {
    return Layout(plot).drawing();
}

} // namespace aolib::bench
