#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

#include <aolib/bake/AbstractBaker.h>
#include <aolib/bake/BakeScene.h>

#include "bake/geometry/BakeGeometry.h"

namespace aolib::bake {

/// Why a triangle gets no texels.
enum class UvFault : std::uint8_t { None, Missing, NotFinite, Outside, Collapsed };

/// What is wrong with a triangle's UVs, for a map of `size` texels.
UvFault uvFault(const Surface& surface, std::uint32_t triangle, const glm::dvec2& size);

/// Which triangle each texel of a map shows: the one that its centre lies in, or else, where a
/// chart touches the texel but not its centre, the one that comes nearest to the centre. Another
/// place than the centre may be looked at.
class TexelRaster {
public:
    /// Rasterises all surfaces that go to `map`.
    /// @param place  in each texel, (0,0) to (1,1).
    TexelRaster(const BakeScene& scene, int map, int width, int height,
                const glm::dvec2& place = glm::dvec2(0.5));

    int width() const { return width_; }
    int height() const { return height_; }
    std::size_t size() const { return kind_.size(); }
    TexelKind kind(std::size_t texel) const { return kind_[texel]; }
    const std::vector<TexelKind>& kinds() const { return kind_; }
    /// Of a texel that is not empty.
    const TriangleName& triangle(std::size_t texel) const { return triangle_[texel]; }
    /// Weights of the triangle's second and third vertex: of the texel's centre, or of the
    /// triangle's point next to it; a tenth of a texel from its edges, where it is wide enough.
    const glm::vec2& barycentric(std::size_t texel) const { return barycentric_[texel]; }

    std::size_t coveredTexels() const;
    /// Of the covered ones, those whose centre lies well inside two or more triangles.
    std::size_t overlappingTexels() const { return overlapping_; }

private:
    struct Corners;
    void add(const Corners& corners, const TriangleName& name);
    void visit(const Corners& corners, const TriangleName& name, int x, int y);

    int width_;
    int height_;
    glm::dvec2 place_;
    std::vector<TexelKind> kind_;
    std::vector<TriangleName> triangle_;
    std::vector<glm::vec2> barycentric_;
    /// Of border texels: squared distance of the point taken from the centre, texels. Of inside
    /// ones: 1 once a centre lay well inside a triangle, 2 when that happened again.
    std::vector<float> mark_;
    std::size_t overlapping_ = 0;
};

} // namespace aolib::bake
