#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include <aolib/Status.h>

#include "bake/geometry/BakeGeometry.h"
#include "bake/gpu/LightView.h"
#include "gl/Buffer.h"
#include "gl/Container.h"
#include "gl/GLSLShader.h"

namespace aolib::bake {

class Facets;

/// Triangles `first` to `first + count` - 1 of a buffer.
struct TriangleRange {
    std::size_t first = 0;
    std::size_t count = 0;
};

/// A scene's triangles in GPU memory: positions in the frame (location 0), shading normals, zero
/// where there are none (1), and u, v, the number of the map, -1 for what only occludes, and of the
/// facet (2).
class BakeVertices {
public:
    BakeVertices() = default;
    /// @param width,height  of the maps: decide which triangles are too thin in them.
    /// @param facets  null: all facet numbers are 0.
    /// @param kept    whether the triangles stay in memory, too.
    /// Errors: OutOfMemory.
    static Result<BakeVertices> create(const gl::Functions& gl, const BakeGeometry& geometry,
                                       const BakeFrame& frame, int width, int height,
                                       const Facets* facets, bool kept);

    void draw() const;
    /// The same for a program that is bound and has a uniform `uFirst`: the number of the first
    /// triangle of a draw call, from 1. In pieces: a software rasteriser asks for memory for all
    /// vertices of a call, and gives it back.
    void drawNumbered(gl::GLSLShader& shader) const;
    /// The same for some of the triangles: of a buffer of indices, numbered from there.
    void drawNumbered(gl::GLSLShader& shader, const gl::Buffer& indices,
                      const TriangleRange& range) const;

    /// Positions in the frame and three indices per triangle, where they are kept.
    const std::vector<glm::vec3>& positions() const { return positions_; }
    const std::vector<std::uint32_t>& indices() const { return kept_; }

private:
    const gl::Functions* gl_ = nullptr;
    gl::Container name_;
    gl::Buffer vertices_;
    gl::Buffer indices_;
    GLsizei indexCount_ = 0;
    std::vector<glm::vec3> positions_;
    std::vector<std::uint32_t> kept_;
};

} // namespace aolib::bake
