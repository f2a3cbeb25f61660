#include "bench/SurfaceElements.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include <glm/geometric.hpp>

#include "bench/CreaseWeld.h"
#include "bench/TriangleGrid.h"
#include "parallel/ParallelLoop.h"
#include "scene/Solids.h"

namespace aolib::bench {

namespace {

constexpr int kPasses = 2;
/// Nodes are taken as one disc from so many times their extent away.
constexpr float kFarAway = 1.5F;
/// Subdivision begins with edges of this share of the radius, and gets coarser until the elements
/// are few enough.
constexpr double kEdgeShare = 0.125;
constexpr double kCoarser = 1.1;
constexpr std::uint32_t kMostSplits = 256;

struct Corners {
    glm::vec3 a;
    glm::vec3 b;
    glm::vec3 c;

    float longestEdge() const {
        return std::max({glm::distance(a, b), glm::distance(b, c), glm::distance(c, a)});
    }
};

Corners cornersOf(const TriangleMesh& mesh, std::size_t triangle) {
    const std::uint32_t* index = &mesh.indices[triangle * 3];
    return {mesh.positions[index[0]], mesh.positions[index[1]], mesh.positions[index[2]]};
}

std::uint32_t splitsFor(float edge, double part) {
    const double splits = std::ceil(double{edge} / part);
    return static_cast<std::uint32_t>(std::clamp(splits, 1.0, double(kMostSplits)));
}

/// The length of a part, so that about as many elements come out as asked for.
double partLength(const std::vector<float>& edges, const SurfaceElements::Settings& settings) {
    for (double part = kEdgeShare * settings.radius;; part *= kCoarser) {
        double elements = 0.0;
        bool whole = true;
        for (const float edge : edges) {
            const double splits = splitsFor(edge, part);
            elements += 0.5 * splits * splits;
            whole = whole && splits <= 1.0;
        }
        if (whole || elements <= double(settings.elements)) {
            return part;
        }
    }
}

Solids solidsOf(const TriangleMesh& mesh) {
    Mesh whole;
    whole.positions = mesh.positions;
    whole.indices = mesh.indices;
    for (const glm::vec3& position : mesh.positions) {
        whole.modelBounds.include(position);
    }
    return findSolids(whole);
}

/// Which of six directions a normal points along most.
std::size_t mainDirection(const glm::vec3& normal) {
    const glm::vec3 size = glm::abs(normal);
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    return static_cast<std::size_t>(2 * axis + (normal[axis] < 0.0F ? 1 : 0));
}

} // namespace

SurfaceElements::SurfaceElements(const TriangleMesh& mesh, const Settings& settings) {
    subdivide(mesh, settings);
    buildTrees();
    for (int i = 0; i < kPasses; ++i) {
        const std::vector<Element> before = elements_;
        gatherNodes();
        pass(static_cast<float>(settings.radius));
        for (std::size_t e = 0; i > 0 && e < elements_.size(); ++e) {
            elements_[e].front = 0.5F * (elements_[e].front + before[e].front);
            elements_[e].back = 0.5F * (elements_[e].back + before[e].back);
        }
    }
}

void SurfaceElements::subdivide(const TriangleMesh& mesh, const Settings& settings) {
    const Solids solids = solidsOf(mesh);
    std::vector<float> edges(mesh.triangleCount());
    for (std::size_t t = 0; t < edges.size(); ++t) {
        edges[t] = cornersOf(mesh, t).longestEdge();
    }
    const double part = partLength(edges, settings);
    CreaseWeld weld(static_cast<float>(part));
    for (std::size_t t = 0; t < edges.size(); ++t) {
        const Corners p = cornersOf(mesh, t);
        const TriangleGrid grid{splitsFor(edges[t], part)};
        splits_.push_back(grid.splits);
        firstCorner_.push_back(corners_.size());
        const glm::vec3 cross = glm::cross(p.b - p.a, p.c - p.a);
        const float twice = glm::length(cross);
        const bool turned = solids.indices[t * 3 + 1] != mesh.indices[t * 3 + 1];
        const glm::vec3 normal =
            twice > 0.0F ? (turned ? -cross : cross) / twice : glm::vec3(0.0F, 1.0F, 0.0F);
        const auto n = static_cast<float>(grid.splits);
        const float area = 0.5F * twice / static_cast<float>(grid.points());
        for (std::uint32_t j = 0; j <= grid.splits; ++j) {
            for (std::uint32_t i = 0; i + j <= grid.splits; ++i) {
                const glm::vec3 position = p.a + (p.b - p.a) * (static_cast<float>(i) / n) +
                                           (p.c - p.a) * (static_cast<float>(j) / n);
                corners_.push_back(weld.add(position, normal, area));
            }
        }
        const std::uint32_t solid = solids.solidOfVertex[mesh.indices[t * 3]];
        elements_.resize(weld.vertices().size());
        for (std::size_t c = firstCorner_.back(); c < corners_.size(); ++c) {
            elements_[corners_[c]].solid = solid >= 1 && solid <= solids.count();
        }
    }
    for (std::size_t e = 0; e < elements_.size(); ++e) {
        const CreaseWeld::Vertex& vertex = weld.vertices()[e];
        elements_[e].position = vertex.position;
        elements_[e].area = vertex.area;
        elements_[e].normal = vertex.unitNormal();
    }
}

// ---- Hierarchy ----------------------------------------------------------------------------------

void SurfaceElements::buildTrees() {
    std::array<std::vector<std::uint32_t>, 6> groups;
    for (std::uint32_t e = 0; e < elements_.size(); ++e) {
        groups[mainDirection(elements_[e].normal)].push_back(e);
    }
    for (const std::vector<std::uint32_t>& group : groups) {
        if (group.empty()) {
            continue;
        }
        const auto first = static_cast<std::uint32_t>(order_.size());
        order_.insert(order_.end(), group.begin(), group.end());
        roots_.push_back(buildNode(first, static_cast<std::uint32_t>(order_.size())));
    }
}

/// Halves the elements along the longest side of their box, down to single ones.
std::uint32_t SurfaceElements::buildNode(std::uint32_t first, std::uint32_t last) {
    const auto index = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back({});
    nodes_[index].first = first;
    nodes_[index].last = last;
    if (last - first == 1) {
        return index;
    }
    glm::vec3 low = elements_[order_[first]].position;
    glm::vec3 high = low;
    for (std::uint32_t i = first; i < last; ++i) {
        low = glm::min(low, elements_[order_[i]].position);
        high = glm::max(high, elements_[order_[i]].position);
    }
    const glm::vec3 size = high - low;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const std::uint32_t middle = first + (last - first) / 2;
    std::nth_element(order_.begin() + first, order_.begin() + middle, order_.begin() + last,
                     [&](std::uint32_t a, std::uint32_t b) {
                         return elements_[a].position[axis] < elements_[b].position[axis];
                     });
    const std::uint32_t left = buildNode(first, middle);
    const std::uint32_t right = buildNode(middle, last);
    nodes_[index].left = left;
    nodes_[index].right = right;
    return index;
}

/// Sums up what nodes let through, children before parents.
void SurfaceElements::gatherNodes() {
    for (std::size_t i = nodes_.size(); i-- > 0;) {
        Node& node = nodes_[i];
        if (node.left == 0) {
            const Element& e = elements_[order_[node.first]];
            node.center = e.position;
            node.area = e.area;
            node.extent = 0.0F;
            node.throughFront = e.area * e.front * e.normal;
            node.throughBack = e.solid ? glm::vec3(0.0F) : e.area * e.back * e.normal;
            continue;
        }
        const Node& a = nodes_[node.left];
        const Node& b = nodes_[node.right];
        node.area = a.area + b.area;
        const float share = node.area > 0.0F ? b.area / node.area : 0.5F;
        node.center = glm::mix(a.center, b.center, share);
        node.extent = std::max(glm::distance(node.center, a.center) + a.extent,
                               glm::distance(node.center, b.center) + b.extent);
        node.throughFront = a.throughFront + b.throughFront;
        node.throughBack = a.throughBack + b.throughBack;
    }
}

// ---- Form factors -------------------------------------------------------------------------------

void SurfaceElements::pass(float radius) {
    std::vector<std::array<float, 2>> result(elements_.size());
    const auto body = [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const Element& e = elements_[i];
            result[i][0] = std::max(0.0F, 1.0F - occlusion(e.position, e.normal, radius));
            result[i][1] = std::max(0.0F, 1.0F - occlusion(e.position, -e.normal, radius));
        }
    };
    parallelLoop(elements_.size(), 0, body, {});
    for (std::size_t i = 0; i < elements_.size(); ++i) {
        elements_[i].front = result[i][0];
        elements_[i].back = result[i][1];
    }
}

/// The sum of form factors of all discs before a receiver: `cos A' / (pi r^2 + A)` with A' the area
/// as seen from there, times the light that reaches its far side.
float SurfaceElements::occlusion(const glm::vec3& position, const glm::vec3& normal,
                                 float radius) const {
    std::array<std::uint32_t, 128> stack{};
    std::size_t height = 0;
    for (const std::uint32_t root : roots_) {
        stack[height++] = root;
    }
    float sum = 0.0F;
    while (height > 0) {
        const Node& node = nodes_[stack[--height]];
        const glm::vec3 to = node.center - position;
        const float distance = glm::length(to);
        if (distance - node.extent >= radius || glm::dot(to, normal) + node.extent <= 0.0F) {
            continue;
        }
        const bool whole = node.left == 0 || distance > kFarAway * node.extent;
        if (!whole) {
            stack[height++] = node.left;
            stack[height++] = node.right;
            continue;
        }
        if (distance <= 0.0F || distance >= radius) {
            continue;
        }
        const glm::vec3 direction = to / distance;
        const float through = std::max(glm::dot(node.throughFront, direction),
                                       -glm::dot(node.throughBack, direction));
        const float cosine = glm::dot(normal, direction);
        if (through > 0.0F && cosine > 0.0F) {
            sum += cosine * through / (std::numbers::pi_v<float> * distance * distance + node.area);
        }
    }
    return sum;
}

float SurfaceElements::visibility(std::uint32_t triangle, double u, double v,
                                  const glm::vec3& normal) const {
    const TriangleGrid::Place place = TriangleGrid{splits_[triangle]}.locate(u, v);
    double sum = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
        const Element& e = elements_[corners_[firstCorner_[triangle] + place.corners[k]]];
        const bool front = glm::dot(e.normal, normal) >= 0.0F;
        sum += place.weights[k] * double{front ? e.front : e.back};
    }
    return static_cast<float>(std::clamp(sum, 0.0, 1.0));
}

} // namespace aolib::bench
