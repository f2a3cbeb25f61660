#pragma once

#include <cstdint>
#include <span>

#include <aolib/Status.h>

#include "bake/gpu/BakeVertices.h"
#include "bake/gpu/SlabBins.h"
#include "gl/Buffer.h"
#include "gl/GLSLShader.h"

namespace aolib::bake {

/// Draws the triangles of a direction's slabs, each slab's by themselves.
class SlabTriangles {
public:
    /// The vertices, which keep their triangles, must outlive it.
    SlabTriangles(const gl::Functions& gl, const BakeVertices& vertices)
        : gl_(&gl), vertices_(&vertices), bins_(vertices.positions(), vertices.indices()) {}

    void begin(const Slabs& slabs) { bins_.begin(slabs); }
    /// Makes slabs `first` to `last` - 1 ready to be drawn, and no others. Errors: OutOfMemory.
    AoStatus prepare(int first, int last);

    bool empty(int slab) const { return bins_.bin(slab).count == 0; }
    /// As BakeVertices::drawNumbered(), numbered from the slab's first triangle on.
    void draw(gl::GLSLShader& shader, int slab) const;
    /// The numbers in the scene of those that draw() draws.
    std::span<const std::uint32_t> numbers(int slab) const;

private:
    const gl::Functions* gl_;
    const BakeVertices* vertices_;
    SlabBins bins_;
    gl::Buffer indices_;
};

} // namespace aolib::bake
