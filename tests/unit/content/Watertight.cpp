#include "Watertight.h"

#include <array>
#include <map>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace aolib::test {

std::size_t unbalancedEdges(const ModelMesh& mesh) {
    std::map<std::array<float, 3>, int> points;
    const auto point = [&](std::uint32_t index) {
        const glm::vec3 p = mesh.positions[index] + 0.0F; // -0 becomes 0
        return points.try_emplace({p.x, p.y, p.z}, static_cast<int>(points.size())).first->second;
    };
    std::map<std::pair<int, int>, int> balance;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        for (std::size_t k = 0; k < 3; ++k) {
            const int a = point(mesh.indices[i + k]);
            const int b = point(mesh.indices[i + (k + 1) % 3]);
            balance[{a < b ? a : b, a < b ? b : a}] += a < b ? 1 : -1;
        }
    }
    std::size_t count = 0;
    for (const auto& [edge, sum] : balance) {
        count += sum != 0 ? 1 : 0;
    }
    return count;
}

double signedVolume(const ModelMesh& mesh) {
    double volume = 0.0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const glm::dvec3 a(mesh.positions[mesh.indices[i]]);
        const glm::dvec3 b(mesh.positions[mesh.indices[i + 1]]);
        const glm::dvec3 c(mesh.positions[mesh.indices[i + 2]]);
        volume += glm::dot(a, glm::cross(b, c)) / 6.0;
    }
    return volume;
}

} // namespace aolib::test
