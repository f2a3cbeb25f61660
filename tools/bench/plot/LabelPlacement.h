#pragma once

#include <vector>

#include <glm/vec2.hpp>

namespace aolib::bench {

/// A rectangle, pixels.
struct Box {
    glm::dvec2 low{0.0};
    glm::dvec2 high{0.0};
};

/// Finds places for labels beside points, clear of markers, lines and each other as far as that
/// goes: each takes the place around its point that covers least.
class LabelPlacement {
public:
    explicit LabelPlacement(const Box& area) : area_(area) {}

    /// Something that labels had better not cover.
    void block(const Box& box) { blocked_.push_back(box); }
    void blockLine(const std::vector<glm::dvec2>& points);

    /// Where a label of this size goes, beside a marker of this radius; then it is blocked.
    Box place(const glm::dvec2& point, double radius, const glm::dvec2& size);

private:
    double cost(const Box& box) const;

    Box area_;
    std::vector<Box> blocked_;
    std::vector<glm::dvec2> onLines_;
};

} // namespace aolib::bench
