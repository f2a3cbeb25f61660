#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "scene/TriangleMesh.h"

namespace aolib::bench {

/// Ambient occlusion from surface elements (Bunnell, GPU Gems 2, chapter 14; the thesis compares
/// with it in 5.2): every vertex stands for a disc of the area about it, discs shadow each other by
/// an approximate form factor, far ones through a hierarchy, and a second pass weighs each disc by
/// how much light reaches its own far side, so that discs in a row do not count twice.
///
/// Made as good as the idea allows here: large triangles are subdivided, vertices at creases are
/// split, both sides of a surface are computed, sheets shadow both ways, solids with their backs
/// alone, the hierarchy is one tree per main direction of normals, so that opposite discs do not
/// cancel, and the result is the mean of both passes: the first is too dark, the second too bright.
class SurfaceElements {
public:
    struct Settings {
        double radius = 1.0;          ///< reach of occluders, world units; step falloff
        std::size_t elements = 20000; ///< triangles are subdivided up to about so many
    };

    /// Computes everything, on all cores.
    SurfaceElements(const TriangleMesh& mesh, const Settings& settings);

    /// W at a point of a triangle of the mesh, interpolated.
    /// @param u,v  barycentric weights of the triangle's second and third vertex.
    /// @param normal  of the side that is asked for.
    float visibility(std::uint32_t triangle, double u, double v, const glm::vec3& normal) const;

    std::size_t count() const { return elements_.size(); }

private:
    struct Element {
        glm::vec3 position{0.0F};
        glm::vec3 normal{0.0F}; ///< unit length; outwards, where the element belongs to a solid
        float area = 0.0F;
        bool solid = false;
        float front = 1.0F; ///< W on the normal's side
        float back = 1.0F;  ///< W on the other side
    };
    /// Elements that act as one disc from far away.
    struct Node {
        glm::vec3 center{0.0F};
        float extent = 0.0F; ///< all elements lie within this distance of `center`
        float area = 0.0F;
        glm::vec3 throughFront{0.0F}; ///< sum of area * W of the front * normal
        glm::vec3 throughBack{0.0F};  ///< the same of the back, sheets alone
        std::uint32_t first = 0;      ///< elements of this node, in `order_`
        std::uint32_t last = 0;
        std::uint32_t left = 0; ///< children; 0 for a leaf, the root being nobody's child
        std::uint32_t right = 0;
    };

    void subdivide(const TriangleMesh& mesh, const Settings& settings);
    void buildTrees();
    std::uint32_t buildNode(std::uint32_t first, std::uint32_t last);
    void gatherNodes();
    void pass(float radius);
    float occlusion(const glm::vec3& position, const glm::vec3& normal, float radius) const;

    std::vector<Element> elements_;
    std::vector<std::uint32_t> order_; ///< elements, tree by tree
    std::vector<Node> nodes_;          ///< children after their parents
    std::vector<std::uint32_t> roots_;
    std::vector<std::uint32_t> splits_;    ///< per triangle: parts along an edge
    std::vector<std::size_t> firstCorner_; ///< per triangle: where its corners begin
    std::vector<std::uint32_t> corners_;   ///< element per grid point of a triangle
};

} // namespace aolib::bench
