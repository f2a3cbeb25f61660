#include "scene/Solids.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <map>
#include <numeric>

namespace aolib {

namespace {

/// For every vertex the number of the first one at the same position.
std::vector<std::uint32_t> weld(const std::vector<glm::vec3>& positions) {
    std::vector<std::uint32_t> order(positions.size());
    std::iota(order.begin(), order.end(), 0U);
    const auto less = [&](std::uint32_t a, std::uint32_t b) {
        const glm::vec3& p = positions[a];
        const glm::vec3& q = positions[b];
        return p.x != q.x ? p.x < q.x : p.y != q.y ? p.y < q.y : p.z != q.z ? p.z < q.z : a < b;
    };
    std::sort(order.begin(), order.end(), less);
    std::vector<std::uint32_t> first(positions.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        const bool same = i > 0 && positions[order[i]] == positions[order[i - 1]];
        first[order[i]] = same ? first[order[i - 1]] : order[i];
    }
    return first;
}

/// Union-find over vertices.
class Components {
public:
    explicit Components(std::size_t count) : parent_(count) {
        std::iota(parent_.begin(), parent_.end(), 0U);
    }
    std::uint32_t find(std::uint32_t v) {
        while (parent_[v] != v) {
            parent_[v] = parent_[parent_[v]];
            v = parent_[v];
        }
        return v;
    }
    void join(std::uint32_t a, std::uint32_t b) { parent_[find(a)] = find(b); }

private:
    std::vector<std::uint32_t> parent_;
};

struct Edge {
    std::uint32_t low;
    std::uint32_t high;
    int balance; ///< +1 when run through from low to high, -1 the other way
};

/// Whether each component's edges balance; by its root.
std::vector<bool> findClosed(const std::vector<std::uint32_t>& welded, Components& components) {
    std::vector<Edge> edges;
    edges.reserve(welded.size());
    for (std::size_t t = 0; t < welded.size(); t += 3) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = welded[t + k];
            const std::uint32_t b = welded[t + (k + 1) % 3];
            if (a != b) {
                edges.push_back({std::min(a, b), std::max(a, b), a < b ? 1 : -1});
            }
        }
    }
    std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
        return a.low != b.low ? a.low < b.low : a.high < b.high;
    });
    std::uint32_t vertices = 0;
    for (const std::uint32_t v : welded) {
        vertices = std::max(vertices, v + 1);
    }
    std::vector<bool> closed(vertices, true);
    for (std::size_t i = 0; i < edges.size();) {
        int balance = 0;
        const std::size_t start = i;
        for (; i < edges.size() && edges[i].low == edges[start].low &&
               edges[i].high == edges[start].high;
             ++i) {
            balance += edges[i].balance;
        }
        if (balance != 0) {
            closed[components.find(edges[start].low)] = false;
        }
    }
    return closed;
}

/// Six times the signed volume of the tetrahedron between the origin and a triangle.
double volume(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    return glm::dot(a, glm::cross(b, c));
}

} // namespace

Solids findSolids(const Mesh& mesh) {
    const std::vector<std::uint32_t> first = weld(mesh.positions);
    Components components(mesh.positions.size());
    std::vector<std::uint32_t> welded(mesh.indices.size());
    for (std::size_t i = 0; i < welded.size(); ++i) {
        welded[i] = first[mesh.indices[i]];
    }
    for (std::size_t t = 0; t < welded.size(); t += 3) {
        components.join(welded[t], welded[t + 1]);
        components.join(welded[t], welded[t + 2]);
    }
    const std::vector<bool> closed = findClosed(welded, components);

    Solids solids;
    solids.indices = mesh.indices;
    std::map<std::uint32_t, std::uint32_t> solidOfRoot;
    std::vector<double> volumes;
    const glm::dvec3 origin(mesh.modelBounds.center());
    for (std::size_t t = 0; t < welded.size(); t += 3) {
        const std::uint32_t root = components.find(welded[t]);
        if (!closed[root]) {
            solids.openMesh = true;
            continue;
        }
        const auto [entry, isNew] =
            solidOfRoot.try_emplace(root, static_cast<std::uint32_t>(solids.bounds.size()));
        if (isNew) {
            solids.bounds.emplace_back();
            volumes.push_back(0.0);
        }
        std::array<glm::dvec3, 3> corner;
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::vec3& position = mesh.positions[welded[t + k]];
            solids.bounds[entry->second].include(position);
            corner[k] = glm::dvec3(position) - origin;
        }
        volumes[entry->second] += volume(corner[0], corner[1], corner[2]);
    }
    const std::uint32_t openMesh = Solids::kOpenMesh + solids.count();
    solids.solidOfVertex.assign(mesh.positions.size(), openMesh);
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        const auto found = solidOfRoot.find(components.find(first[v]));
        solids.solidOfVertex[v] = found == solidOfRoot.end() ? openMesh : found->second + 1;
    }
    for (std::size_t t = 0; t < solids.indices.size(); t += 3) {
        const std::uint32_t solid = solids.solidOfVertex[solids.indices[t]];
        if (solid < Solids::kOpenMesh && volumes[solid - 1] < 0.0) {
            std::swap(solids.indices[t + 1], solids.indices[t + 2]);
        }
    }
    return solids;
}

std::vector<std::uint32_t> enclosingSolids(const Mesh& mesh, const Solids& solids,
                                           const glm::vec3& point) {
    std::vector<bool> inside(solids.bounds.size(), false);
    bool any = false;
    for (const Bounds& bounds : solids.bounds) {
        any = any || bounds.contains(point);
    }
    if (!any) {
        return {};
    }
    // A direction that no modeller uses, so that the ray meets no edge.
    const glm::dvec3 direction = glm::normalize(glm::dvec3(0.5773, 0.6181, 0.5336));
    for (std::size_t t = 0; t < solids.indices.size(); t += 3) {
        const std::uint32_t solid = solids.solidOfVertex[solids.indices[t]];
        if (solid >= Solids::kOpenMesh || !solids.bounds[solid - 1].contains(point)) {
            continue;
        }
        const auto corner = [&](std::size_t k) {
            return glm::dvec3(mesh.positions[solids.indices[t + k]]) - glm::dvec3(point);
        };
        const glm::dvec3 a = corner(0);
        const glm::dvec3 b = corner(1);
        const glm::dvec3 c = corner(2);
        // The ray from the origin crosses the triangle when it passes all edges on one side.
        const double u = glm::dot(direction, glm::cross(b, c));
        const double v = glm::dot(direction, glm::cross(c, a));
        const double w = glm::dot(direction, glm::cross(a, b));
        const bool crosses = (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);
        const double sum = u + v + w;
        if (crosses && sum != 0.0 && glm::dot(direction, u * a + v * b + w * c) / sum > 0.0) {
            inside[solid - 1] = !inside[solid - 1];
        }
    }
    std::vector<std::uint32_t> enclosing;
    for (std::uint32_t s = 0; s < inside.size(); ++s) {
        if (inside[s]) {
            enclosing.push_back(s);
        }
    }
    return enclosing;
}

} // namespace aolib
