#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include <glm/vec3.hpp>

namespace aolib::bench {

/// Joins corners of triangles to vertices: those at the same place, as long as their normals differ
/// by no more than a crease.
class CreaseWeld {
public:
    struct Vertex {
        glm::vec3 position{0.0F};
        glm::vec3 normal{0.0F}; ///< sum over the corners, weighted by area
        float area = 0.0F;
        std::uint32_t next = 0; ///< the next one at the same place, 0 for none

        glm::vec3 unitNormal() const;
    };

    /// @param size  typical distance of vertices, world units: corners nearer than a thousandth of
    /// it are at the same place.
    explicit CreaseWeld(float size);

    /// @param normal  unit length. Returns the vertex's number.
    std::uint32_t add(const glm::vec3& position, const glm::vec3& normal, float area);

    const std::vector<Vertex>& vertices() const { return vertices_; }

private:
    std::uint64_t cellOf(const glm::vec3& position) const;

    float cell_;
    std::unordered_map<std::uint64_t, std::uint32_t> firstIn_; ///< by cell: 1 + number
    std::vector<Vertex> vertices_;
};

} // namespace aolib::bench
