#include "bench/plot/Painter.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "bench/plot/StrokeFont.h"

namespace aolib::bench {

namespace {

constexpr double kFontWeight = 0.085; ///< width of a stroke, share of the font's size
constexpr double kBoldWeight = 0.13;

double distanceToSegment(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b) {
    const glm::dvec2 along = b - a;
    const double square = glm::dot(along, along);
    const double t = square > 0.0 ? std::clamp(glm::dot(p - a, along) / square, 0.0, 1.0) : 0.0;
    return glm::distance(p, a + t * along);
}

/// Below 0 inside. @param points  of a convex polygon, either way round.
double distanceToPolygon(const glm::dvec2& p, const std::vector<glm::dvec2>& points) {
    double nearest = 1e30;
    bool left = true;
    bool right = true;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const glm::dvec2& a = points[i];
        const glm::dvec2& b = points[(i + 1) % points.size()];
        nearest = std::min(nearest, distanceToSegment(p, a, b));
        const double side = (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
        left = left && side >= 0.0;
        right = right && side <= 0.0;
    }
    return left || right ? -nearest : nearest;
}

/// Cuts a line into dashes as long as the gaps between them.
std::vector<Polyline> dashesOf(const Polyline& line) {
    std::vector<Polyline> dashes;
    double place = 0.0; // within a dash and a gap
    for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
        const glm::dvec2 a = line.points[i];
        const glm::dvec2 b = line.points[i + 1];
        const double length = glm::distance(a, b);
        for (double t = 0.0; t < length;) {
            const bool drawn = place < line.dash;
            const double step = std::min((drawn ? line.dash : 2.0 * line.dash) - place, length - t);
            if (drawn) {
                dashes.push_back({{glm::mix(a, b, t / length), glm::mix(a, b, (t + step) / length)},
                                  line.colour,
                                  line.width,
                                  0.0});
            }
            t += step;
            place = std::fmod(place + step, 2.0 * line.dash);
            if (step <= 0.0) {
                break;
            }
        }
    }
    return dashes;
}

class Canvas {
public:
    Canvas(double width, double height, double scale)
        : scale_(scale), image_(static_cast<int>(std::lround(width * scale)),
                                static_cast<int>(std::lround(height * scale)), 3, 255) {}

    void operator()(const Polyline& line) {
        if (line.dash > 0.0) {
            for (const Polyline& dash : dashesOf(line)) {
                (*this)(dash);
            }
            return;
        }
        const std::vector<glm::dvec2> points = scaled(line.points);
        const double half = 0.5 * line.width * scale_;
        fill(points, half, line.colour, [&](const glm::dvec2& p) {
            double nearest = 1e30;
            for (std::size_t i = 0; i + 1 < points.size(); ++i) {
                nearest = std::min(nearest, distanceToSegment(p, points[i], points[i + 1]));
            }
            return nearest - half;
        });
    }
    void operator()(const Polygon& polygon) {
        const std::vector<glm::dvec2> points = scaled(polygon.points);
        const double half = 0.5 * polygon.outlineWidth * scale_;
        const auto distance = [&](const glm::dvec2& p) { return distanceToPolygon(p, points); };
        if (half > 0.0) {
            fill(points, half, polygon.outline,
                 [&](const glm::dvec2& p) { return distance(p) - half; });
        }
        fill(points, 0.0, polygon.fill, [&](const glm::dvec2& p) { return distance(p) + half; });
    }
    void operator()(const Disc& disc) {
        const glm::dvec2 center = disc.center * scale_;
        const double radius = disc.radius * scale_;
        const double half = 0.5 * disc.outlineWidth * scale_;
        const auto distance = [&](const glm::dvec2& p) {
            return glm::distance(p, center) - radius;
        };
        if (half > 0.0) {
            fill({center}, radius + half, disc.outline,
                 [&](const glm::dvec2& p) { return distance(p) - half; });
        }
        fill({center}, radius, disc.fill, [&](const glm::dvec2& p) { return distance(p) + half; });
    }
    void operator()(const Text& text) {
        const double width = textWidth(text.text, text.size);
        const double shift = text.anchor == Anchor::Start    ? 0.0
                             : text.anchor == Anchor::Middle ? -0.5 * width
                                                             : -width;
        const double weight = text.size * (text.bold ? kBoldWeight : kFontWeight);
        for (std::vector<glm::dvec2>& stroke : textStrokes(text.text, text.size)) {
            for (glm::dvec2& p : stroke) {
                p.x += shift;
                p = text.position + (text.upwards ? glm::dvec2(p.y, -p.x) : p);
            }
            (*this)(Polyline{std::move(stroke), text.colour, weight, 0.0});
        }
    }

    ByteImage take() { return std::move(image_); }

private:
    std::vector<glm::dvec2> scaled(std::vector<glm::dvec2> points) const {
        for (glm::dvec2& p : points) {
            p *= scale_;
        }
        return points;
    }

    /// Blends a colour over every pixel near `points`, by how far inside a shape it lies.
    /// @param distance  from a point to the shape's edge, pixels; below 0 inside.
    template <typename Distance>
    void fill(const std::vector<glm::dvec2>& points, double reach, const Colour& colour,
              const Distance& distance) {
        glm::dvec2 low(1e30);
        glm::dvec2 high(-1e30);
        for (const glm::dvec2& p : points) {
            low = glm::min(low, p - reach - 1.0);
            high = glm::max(high, p + reach + 1.0);
        }
        const int left = std::max(0, static_cast<int>(std::floor(low.x)));
        const int right = std::min(image_.width - 1, static_cast<int>(std::ceil(high.x)));
        const int top = std::max(0, static_cast<int>(std::floor(low.y)));
        const int bottom = std::min(image_.height - 1, static_cast<int>(std::ceil(high.y)));
        for (int y = top; y <= bottom; ++y) {
            for (int x = left; x <= right; ++x) {
                const double d = distance({double(x) + 0.5, double(y) + 0.5});
                blend(x, y, colour, std::clamp(0.5 - d, 0.0, 1.0));
            }
        }
    }

    void blend(int x, int y, const Colour& colour, double alpha) {
        if (alpha <= 0.0) {
            return;
        }
        const std::uint8_t channels[3] = {colour.r, colour.g, colour.b};
        for (int c = 0; c < 3; ++c) {
            std::uint8_t& value = image_.at(x, image_.height - 1 - y, c);
            value = static_cast<std::uint8_t>(
                std::lround((1.0 - alpha) * double(value) + alpha * double(channels[c])));
        }
    }

    double scale_;
    ByteImage image_;
};

} // namespace

ByteImage paint(const Drawing& drawing, double scale) {
    Canvas canvas(drawing.width, drawing.height, scale);
    for (const Shape& shape : drawing.shapes) {
        std::visit(canvas, shape);
    }
    return canvas.take();
}

} // namespace aolib::bench
