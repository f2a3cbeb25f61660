#include "bench/CreaseWeld.h"

#include <cmath>

#include <glm/geometric.hpp>

#include "bench/Fingerprint.h"

namespace aolib::bench {

namespace {

constexpr float kCellShare = 1e-3F;
constexpr float kCreaseCosine = 0.77F; ///< about 40 degrees

} // namespace

glm::vec3 CreaseWeld::Vertex::unitNormal() const {
    const float length = glm::length(normal);
    return length > 0.0F ? normal / length : glm::vec3(0.0F, 1.0F, 0.0F);
}

CreaseWeld::CreaseWeld(float size) : cell_(kCellShare * size) {}

std::uint64_t CreaseWeld::cellOf(const glm::vec3& position) const {
    const std::int64_t cell[3] = {std::llround(position.x / cell_),
                                  std::llround(position.y / cell_),
                                  std::llround(position.z / cell_)};
    Fingerprint fingerprint;
    fingerprint.add(std::span<const std::int64_t>(cell));
    return fingerprint.value();
}

std::uint32_t CreaseWeld::add(const glm::vec3& position, const glm::vec3& normal, float area) {
    std::uint32_t& first = firstIn_[cellOf(position)];
    for (std::uint32_t number = first; number != 0; number = vertices_[number - 1].next) {
        Vertex& vertex = vertices_[number - 1];
        if (glm::dot(vertex.unitNormal(), normal) >= kCreaseCosine) {
            vertex.normal += area * normal;
            vertex.area += area;
            return number - 1;
        }
    }
    Vertex vertex{position, area * normal, area, first};
    vertices_.push_back(vertex);
    first = static_cast<std::uint32_t>(vertices_.size());
    return first - 1;
}

} // namespace aolib::bench
