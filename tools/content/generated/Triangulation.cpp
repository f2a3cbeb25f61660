#include "content/generated/Triangulation.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

namespace aolib {
namespace {

using Point = glm::dvec2;

constexpr double touch = 1e-9; ///< of the squared extent: below it three points are on a line

double turn(const Point& a, const Point& b, const Point& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Ear clipping after the holes were joined to the outline by bridges (Held 2001, without its
/// hashing: the polygons here have tens of points).
class EarClipper {
public:
    EarClipper(const Outline& outline, const std::vector<Outline>& holes);
    std::vector<std::array<std::size_t, 3>> clip();

private:
    const Point& at(std::size_t ringPlace) const { return points_[ring_[ringPlace]]; }
    std::size_t add(const Outline& outline, bool counterClockwise, std::vector<std::size_t>& ring);
    void bridge(const std::vector<std::size_t>& hole);
    bool visible(const Point& a, const Point& b) const;
    bool crosses(const Point& a, const Point& b, const std::vector<std::size_t>& ring) const;
    bool opensTowards(std::size_t ringPlace, const Point& p) const;
    double earQuality(std::size_t place) const;

    std::vector<Point> points_;
    std::vector<std::size_t> ring_;
    std::vector<std::vector<std::size_t>> waitingHoles_;
    double tolerance_ = 0.0;
};

EarClipper::EarClipper(const Outline& outline, const std::vector<Outline>& holes) {
    add(outline, true, ring_);
    Point low = points_[0];
    Point high = points_[0];
    for (const Point& p : points_) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    tolerance_ = touch * glm::dot(high - low, high - low);
    for (const Outline& hole : holes) {
        waitingHoles_.emplace_back();
        add(hole, false, waitingHoles_.back());
    }
    while (!waitingHoles_.empty()) {
        const auto nearest = std::max_element(
            waitingHoles_.begin(), waitingHoles_.end(), [&](const auto& a, const auto& b) {
                const auto right = [&](const std::vector<std::size_t>& hole) {
                    double x = -std::numeric_limits<double>::infinity();
                    for (const std::size_t i : hole) {
                        x = std::max(x, points_[i].x);
                    }
                    return x;
                };
                return right(a) < right(b);
            });
        const std::vector<std::size_t> hole = *nearest;
        bridge(hole);
        waitingHoles_.erase(nearest);
    }
}

std::size_t EarClipper::add(const Outline& outline, bool counterClockwise,
                            std::vector<std::size_t>& ring) {
    const std::size_t base = points_.size();
    double doubledArea = 0.0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Point a(outline[i]);
        const Point b(outline[(i + 1) % outline.size()]);
        doubledArea += a.x * b.y - a.y * b.x;
        points_.push_back(a);
        ring.push_back(base + i);
    }
    if ((doubledArea > 0.0) != counterClockwise) {
        std::reverse(ring.begin(), ring.end());
    }
    return base;
}

bool EarClipper::crosses(const Point& a, const Point& b,
                         const std::vector<std::size_t>& ring) const {
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point& c = points_[ring[i]];
        const Point& d = points_[ring[(i + 1) % ring.size()]];
        const bool ownsEnd = c == a || c == b || d == a || d == b;
        if (!ownsEnd && turn(a, b, c) * turn(a, b, d) <= 0.0 &&
            turn(c, d, a) * turn(c, d, b) <= 0.0) {
            return true;
        }
        const bool passes = c != a && c != b && std::abs(turn(a, b, c)) <= tolerance_ &&
                            glm::dot(c - a, b - a) > 0.0 && glm::dot(c - b, a - b) > 0.0;
        if (passes) {
            return true;
        }
    }
    return false;
}

bool EarClipper::visible(const Point& a, const Point& b) const {
    return !crosses(a, b, ring_) &&
           std::none_of(waitingHoles_.begin(), waitingHoles_.end(),
                        [&](const auto& hole) { return crosses(a, b, hole); });
}

/// Whether p lies in the interior angle at a place of the ring: the test that tells apart the
/// copies of a point that earlier bridges made.
bool EarClipper::opensTowards(std::size_t ringPlace, const Point& p) const {
    const std::size_t count = ring_.size();
    const Point& before = at((ringPlace + count - 1) % count);
    const Point& here = at(ringPlace);
    const Point& after = at((ringPlace + 1) % count);
    const bool leftOfNext = turn(here, after, p) > 0.0;
    const bool leftOfLast = turn(before, here, p) > 0.0;
    return turn(before, here, after) > 0.0 ? leftOfNext && leftOfLast : leftOfNext || leftOfLast;
}

void EarClipper::bridge(const std::vector<std::size_t>& hole) {
    double best = std::numeric_limits<double>::infinity();
    std::size_t fromRing = 0;
    std::size_t fromHole = 0;
    for (std::size_t i = 0; i < ring_.size(); ++i) {
        for (std::size_t k = 0; k < hole.size(); ++k) {
            const Point& p = points_[hole[k]];
            const double distance = glm::distance(at(i), p);
            if (distance < best && opensTowards(i, p) && visible(at(i), p)) {
                best = distance;
                fromRing = i;
                fromHole = k;
            }
        }
    }
    std::vector<std::size_t> joined(ring_.begin(),
                                    ring_.begin() + static_cast<std::ptrdiff_t>(fromRing) + 1);
    for (std::size_t k = 0; k <= hole.size(); ++k) {
        joined.push_back(hole[(fromHole + k) % hole.size()]);
    }
    joined.insert(joined.end(), ring_.begin() + static_cast<std::ptrdiff_t>(fromRing), ring_.end());
    ring_ = std::move(joined);
}

/// How well-shaped the ear at a place is; negative when it is none.
double EarClipper::earQuality(std::size_t place) const {
    const std::size_t count = ring_.size();
    const Point& a = at((place + count - 1) % count);
    const Point& b = at(place);
    const Point& c = at((place + 1) % count);
    const double area = turn(a, b, c);
    if (area <= tolerance_) {
        return -1.0;
    }
    for (std::size_t i = 0; i < count; ++i) {
        const Point& p = at(i);
        if (p != a && p != b && p != c && turn(a, b, p) >= -tolerance_ &&
            turn(b, c, p) >= -tolerance_ && turn(c, a, p) >= -tolerance_) {
            return -1.0;
        }
    }
    const double edges = glm::dot(b - a, b - a) + glm::dot(c - b, c - b) + glm::dot(a - c, a - c);
    return area / edges;
}

std::vector<std::array<std::size_t, 3>> EarClipper::clip() {
    std::vector<std::array<std::size_t, 3>> triangles;
    while (ring_.size() > 2) {
        double best = -1.0;
        std::size_t ear = 0;
        for (std::size_t i = 0; i < ring_.size(); ++i) {
            const double quality = earQuality(i);
            if (quality > best) {
                best = quality;
                ear = i;
            }
        }
        if (best < 0.0) {
            break;
        }
        const std::size_t count = ring_.size();
        triangles.push_back(
            {ring_[(ear + count - 1) % count], ring_[ear], ring_[(ear + 1) % count]});
        ring_.erase(ring_.begin() + static_cast<std::ptrdiff_t>(ear));
    }
    return triangles;
}

} // namespace

std::vector<std::array<std::size_t, 3>> triangulate(const Outline& outline,
                                                    const std::vector<Outline>& holes) {
    return EarClipper(outline, holes).clip();
}

} // namespace aolib
