#include "bench/plot/LabelPlacement.h"

#include <algorithm>
#include <array>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace aolib::bench {

namespace {

constexpr double kLineStep = 3.0;      ///< pixels between the points that stand for a line
constexpr double kLineCost = 25.0;     ///< square pixels that each of them counts as
constexpr double kOutsideCost = 100.0; ///< square pixels for each one outside
constexpr double kGap = 3.0;           ///< pixels between marker and label

double overlap(const Box& a, const Box& b) {
    const glm::dvec2 size = glm::min(a.high, b.high) - glm::max(a.low, b.low);
    return size.x > 0.0 && size.y > 0.0 ? size.x * size.y : 0.0;
}

bool inside(const Box& box, const glm::dvec2& p) {
    return p.x >= box.low.x && p.x <= box.high.x && p.y >= box.low.y && p.y <= box.high.y;
}

/// Around a point: to the right first, then above, below, left, and the corners; then further out.
struct Candidate {
    glm::dvec2 side; ///< -1, 0 or 1: which way of the point the label lies
    double away;     ///< further out, in heights of the label
};
constexpr std::array<Candidate, 20> kCandidates{
    {{{1, -0.6}, 0},    {{1, 0.6}, 0},    {{1, 0}, 0},    {{0, -1}, 0},     {{0, 1}, 0},
     {{-1, -0.6}, 0},   {{-1, 0.6}, 0},   {{-1, 0}, 0},   {{0.6, -1}, 0.1}, {{0.6, 1}, 0.1},
     {{-0.6, -1}, 0.1}, {{-0.6, 1}, 0.1}, {{1, -1}, 0.7}, {{1, 1}, 0.7},    {{-1, -1}, 0.7},
     {{-1, 1}, 0.7},    {{0, -1}, 1.2},   {{0, 1}, 1.2},  {{0, -1}, 2.4},   {{0, 1}, 2.4}}};

} // namespace

void LabelPlacement::blockLine(const std::vector<glm::dvec2>& points) {
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const double length = glm::distance(points[i], points[i + 1]);
        for (double t = 0.0; t < length; t += kLineStep) {
            onLines_.push_back(glm::mix(points[i], points[i + 1], t / length));
        }
    }
}

double LabelPlacement::cost(const Box& box) const {
    const glm::dvec2 size = box.high - box.low;
    double cost = kOutsideCost * (size.x * size.y - overlap(box, area_));
    for (const Box& other : blocked_) {
        cost += overlap(box, other);
    }
    for (const glm::dvec2& p : onLines_) {
        cost += inside(box, p) ? kLineCost : 0.0;
    }
    return cost;
}

Box LabelPlacement::place(const glm::dvec2& point, double radius, const glm::dvec2& size) {
    Box best;
    double least = 0.0;
    double rank = 0.0;
    for (const Candidate& candidate : kCandidates) {
        const glm::dvec2 reach = radius + kGap + 0.5 * size + candidate.away * size.y;
        const glm::dvec2 center = point + candidate.side * reach;
        const Box box{center - 0.5 * size, center + 0.5 * size};
        const double total = cost(box) + rank;
        if (rank == 0.0 || total < least) {
            least = total;
            best = box;
        }
        rank += 0.05; // of equal places the earlier one
    }
    blocked_.push_back(best);
    return best;
}

} // namespace aolib::bench
