#pragma once

#include <aolib/Status.h>

#include "bake/BakeGeometry.h"
#include "bake/LightView.h"
#include "gl/Buffer.h"
#include "gl/GLSLShader.h"

namespace aolib::bake {

class Facets;

/// A scene's triangles in GPU memory: positions in the frame (location 0), shading normals, zero
/// where there are none (1), and u, v, the number of the map, -1 for what only occludes, and of the
/// facet (2).
class BakeVertices {
public:
    BakeVertices() = default;
    /// @param width,height  of the maps: decide which triangles are too thin in them.
    /// @param facets  null where nobody asks for their numbers, which then are 0.
    /// Errors: OutOfMemory.
    static Result<BakeVertices> create(const gl::Functions& gl, const BakeGeometry& geometry,
                                       const BakeFrame& frame, int width, int height,
                                       const Facets* facets);

    void draw() const;
    /// The same for a program that is bound and has a uniform `uFirst`: the number of the first
    /// triangle of a draw call, from 1. In pieces: a software rasteriser asks for memory for all
    /// vertices of a call, and gives it back.
    void drawNumbered(gl::GLSLShader& shader) const;

private:
    const gl::Functions* gl_ = nullptr;
    gl::VertexArrayName name_;
    gl::Buffer vertices_;
    gl::Buffer indices_;
    GLsizei indexCount_ = 0;
};

} // namespace aolib::bake
