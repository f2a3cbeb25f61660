#include "content/Tessellation.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

namespace aolib {

namespace {

/// Halves edges of one mesh.
class EdgeSplitter {
public:
    EdgeSplitter(ModelMesh& mesh, float longest) : mesh_(mesh), longest_(longest) {}

    /// One round. @return whether any edge was too long.
    bool halve();

private:
    using Edge = std::pair<std::uint32_t, std::uint32_t>;

    glm::vec3 world(std::uint32_t vertex) const {
        return glm::vec3(mesh_.transform * glm::vec4(mesh_.positions[vertex], 1.0F));
    }
    bool tooLong(std::uint32_t a, std::uint32_t b) const {
        return glm::distance(world(a), world(b)) > longest_;
    }
    std::uint32_t middle(std::uint32_t a, std::uint32_t b);
    void split(const std::array<std::uint32_t, 3>& corner, std::vector<std::uint32_t>& out);

    ModelMesh& mesh_;
    float longest_;
    std::map<Edge, std::uint32_t> middles_;
};

std::uint32_t EdgeSplitter::middle(std::uint32_t a, std::uint32_t b) {
    const auto [found, fresh] =
        middles_.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(mesh_.positions.size()));
    if (fresh) {
        mesh_.positions.push_back(0.5F * (mesh_.positions[a] + mesh_.positions[b]));
        if (!mesh_.normals.empty()) {
            const glm::vec3 sum = mesh_.normals[a] + mesh_.normals[b];
            const float length = glm::length(sum);
            mesh_.normals.push_back(length > 0.0F ? sum / length : mesh_.normals[a]);
        }
    }
    return found->second;
}

void EdgeSplitter::split(const std::array<std::uint32_t, 3>& corner,
                         std::vector<std::uint32_t>& out) {
    // Turned so that edge 0 (corners 0 and 1) is split, and edge 2 is not unless all are.
    std::array<bool, 3> cut{};
    std::size_t first = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        cut[i] = tooLong(corner[i], corner[(i + 1) % 3]);
    }
    while (first < 3 && !(cut[first] && !(cut[(first + 2) % 3] && !cut[(first + 1) % 3]))) {
        ++first;
    }
    if (first == 3) {
        out.insert(out.end(), corner.begin(), corner.end());
        return;
    }
    const std::uint32_t a = corner[first];
    const std::uint32_t b = corner[(first + 1) % 3];
    const std::uint32_t c = corner[(first + 2) % 3];
    const std::uint32_t ab = middle(a, b);
    if (!cut[(first + 1) % 3]) {
        out.insert(out.end(), {a, ab, c, ab, b, c});
        return;
    }
    const std::uint32_t bc = middle(b, c);
    if (!cut[(first + 2) % 3]) {
        out.insert(out.end(), {ab, b, bc, a, ab, c, ab, bc, c});
        return;
    }
    const std::uint32_t ca = middle(c, a);
    out.insert(out.end(), {a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca});
}

bool EdgeSplitter::halve() {
    middles_.clear();
    std::vector<std::uint32_t> indices;
    for (std::size_t i = 0; i + 2 < mesh_.indices.size(); i += 3) {
        split({mesh_.indices[i], mesh_.indices[i + 1], mesh_.indices[i + 2]}, indices);
    }
    mesh_.indices = std::move(indices);
    return !middles_.empty();
}

} // namespace

Model tessellated(Model model, float longest, std::size_t mostTriangles) {
    std::vector<EdgeSplitter> splitters;
    splitters.reserve(model.meshes.size());
    for (ModelMesh& mesh : model.meshes) {
        splitters.emplace_back(mesh, longest);
    }
    bool more = true;
    // A round makes at most four of each.
    while (more && 4 * model.triangleCount() <= mostTriangles) {
        more = false;
        for (EdgeSplitter& splitter : splitters) {
            more = splitter.halve() || more;
        }
    }
    return model;
}

} // namespace aolib
