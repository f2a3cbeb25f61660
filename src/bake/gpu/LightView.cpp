#include "bake/gpu/LightView.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "raytracing/CosineSampling.h"
#include "raytracing/SobolSequence.h"

namespace aolib::bake {

namespace {

/// Pixels that stay free along each border: the view is moved by up to one.
constexpr double margin = 1.5;

/// What is thinner than this share of the frame still gets a view of some width: so wide that
/// floats tell its pixels apart.
constexpr double leastExtent = 1e-3;

double unit(std::uint32_t reversed) {
    return (double(bitReversed(reversed)) + 0.5) * 0x1p-32;
}

} // namespace

BakeFrame::BakeFrame(const Bounds& bounds)
    : centre_(0.5 * (glm::dvec3(bounds.min) + glm::dvec3(bounds.max))) {
    const glm::dvec3 half = 0.5 * (glm::dvec3(bounds.max) - glm::dvec3(bounds.min));
    const double radius = glm::length(half);
    scale_ = radius > 0.0 ? 1.0 / radius : 1.0;
    halfExtent_ = half * scale_;
}

glm::dvec3 lightDirection(Sky sky, const glm::dvec3& up, std::uint32_t seed, std::uint32_t index) {
    const SequenceSeed own = sequenceSeed(7, 0, static_cast<int>(seed & 0x7fffffffU));
    const double first = unit(scrambled(index, own.first));
    const double second = unit(scrambled(sobolSecond(index), own.second));
    const double height = sky == Sky::Dome ? first : 2.0 * first - 1.0;
    const double across = std::sqrt(std::max(0.0, 1.0 - height * height));
    const double angle = 2.0 * std::numbers::pi * second;
    return basisAbout(up) * glm::dvec3(across * std::cos(angle), across * std::sin(angle), height);
}

LightView lightView(const BakeFrame& frame, const FrameBox& box, const glm::dvec3& direction,
                    int size, std::uint32_t seed, std::uint32_t index) {
    RandomSequence random(seed, index);
    const double angle = 2.0 * std::numbers::pi * random.next();
    const glm::dmat3 basis = basisAbout(direction);
    const glm::dvec3 x = std::cos(angle) * basis[0] + std::sin(angle) * basis[1];
    const glm::dvec3 y = glm::cross(direction, x);
    const auto reach = [](const glm::dvec3& axis, const glm::dvec3& half) {
        return std::max(leastExtent, glm::dot(glm::abs(axis), half));
    };
    const glm::dvec3 extent(reach(x, box.half), reach(y, box.half),
                            reach(direction, frame.halfExtent()));
    const double inner = double(size) - 2.0 * margin;
    LightView view;
    view.direction = direction;
    view.pixel = 2.0 * glm::dvec2(extent) / inner;
    const glm::dvec2 scale = inner / (double(size) * glm::dvec2(extent));
    const glm::dvec2 middle = glm::dvec2(glm::dot(x, box.centre), glm::dot(y, box.centre)) * scale;
    const glm::dvec2 shift = (glm::dvec2(random.next(), random.next()) - 0.5) * 2.0 / double(size);
    view.phase = random.next();
    // A little more than the scene's depth, so that no plane cuts it.
    const double depth = -0.999 / extent.z;
    glm::dmat4 matrix(1.0);
    for (int axis = 0; axis < 3; ++axis) {
        matrix[axis] = {x[axis] * scale.x, y[axis] * scale.y, direction[axis] * depth, 0.0};
    }
    matrix[3] = {shift.x - middle.x, shift.y - middle.y, 0.0, 1.0};
    view.toClip = glm::mat4(matrix);
    return view;
}

} // namespace aolib::bake
